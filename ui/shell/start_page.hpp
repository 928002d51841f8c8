// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QStringList>
#include <QWidget>
#include <functional>
#include <vector>

class QFrame;
class QLabel;
class QToolButton;
class QVBoxLayout;

namespace sonde::ui {

/// The page over the view while nothing is open: the bundled scenes with their pictures, recent
/// files, and the ways to open something else. It covers its parent.
class StartPage : public QWidget {
  Q_OBJECT
 public:
  explicit StartPage(QWidget* parent);

  /// Shows itself with the present list of recent files, and no complaint.
  void present();
  /// Says why nothing was opened, above all else, with a button to look for it elsewhere.
  void complain(const QString& reason, std::function<void()> locate);

 signals:
  void scene_wanted();
  void meshes_wanted();
  void chosen(const QStringList& files);

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;
  void paintEvent(QPaintEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;

 private:
  QWidget* gallery();
  void show_recent();
  void lay_tiles();

  QFrame* build_complaint();

  QVBoxLayout* recent_;
  std::vector<QToolButton*> tiles_;
  int columns_ = 0;  ///< of the tiles
  QLabel* reason_ = nullptr;
  std::function<void()> locate_;
  QFrame* complaint_;
};

}  // namespace sonde::ui
