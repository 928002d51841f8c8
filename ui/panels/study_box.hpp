// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QGroupBox>
#include <optional>
#include <string>
#include <vector>

class QComboBox;
class QLabel;
class QProgressBar;
class QPushButton;

namespace sonde::ui {

/// How far a study is that is computed beside everything else.
struct StudyProgress {
  double fraction = 0;  ///< 0 to 1
  QString words;        ///< "3 of 14 rows, about 40 s left"
};

/// Where the map comes from: what is shown, what to compute, and the buttons for that.
class StudyBox : public QGroupBox {
  Q_OBJECT
 public:
  StudyBox(const std::vector<std::string>& device_ids, QWidget* parent);

  void set_source(const QString& words, const QString& folder);
  /// A map was computed and is in no folder of the user's yet.
  void set_unsaved(bool unsaved);
  void choose_device(const std::string& id);
  /// The user's choice of what to compute.
  std::string device_id() const;
  std::string kind() const;  ///< empty: all

 signals:
  void load_asked();
  void compute_asked();
  void save_asked();

 private:
  QPushButton* button(const QString& text, const char* object, const QString& doc);

  QComboBox *devices_, *kinds_;
  QLabel* source_;
  QPushButton* save_;
};

/// The line about a study at work, with a button that stops it. Hidden where none is.
class StudyProgressRow : public QWidget {
  Q_OBJECT
 public:
  explicit StudyProgressRow(QWidget* parent);
  void show_progress(const std::optional<StudyProgress>& progress);

 signals:
  void stop_asked();

 private:
  QLabel* words_;
  QProgressBar* bar_;
};

}  // namespace sonde::ui
