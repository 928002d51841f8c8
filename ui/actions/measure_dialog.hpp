// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QDialog>
#include <QElapsedTimer>

#include "engine/study/identification/identification.hpp"
#include "engine/study/identification/pulse_player.hpp"

class QComboBox;
class QDoubleSpinBox;
class QFormLayout;
class QLabel;
class QProgressBar;
class QPushButton;
class QStackedWidget;
class QTableWidget;

namespace sonde::ui {

/// What is to be measured, and with which profile in the place of what is not.
struct MeasureSubject {
  QString device;
  DeviceProfile profile;      ///< with the limits of the device
  double sample_time = 1e-3;  ///< s
  QStringList profiles;       ///< to choose from; empty: there is no choice
};

/// Measures a device, page by page: asks for the person's consent, shows how far it is, and what
/// came of it.
class MeasureDialog : public QDialog {
  Q_OBJECT
 public:
  explicit MeasureDialog(QWidget* parent);

  void show_consent(const MeasureSubject& subject);
  /// Back to the consent, with the reason.
  void show_ended(const QString& reason);
  void show_progress(const PulsePlan& plan, const PulseProgress& progress);
  void show_computing(double fraction);
  void show_result(const Identification& found, const DeviceProfile& before);
  /// `usable`: it can take the place of what holds the probe.
  void show_saved(const QString& file, bool usable);

  PulseLimits limits() const;

  /// Cancels what runs, or else closes. The Esc that has ended it does not close it too: there is a
  /// reason to read.
  void reject() override;

 signals:
  void start_asked();
  void cancel_asked();  ///< of what runs
  void profile_chosen(const QString& id);
  void save_asked();
  void use_asked();

 private:
  QWidget* consent_page();
  QWidget* progress_page();
  QWidget* result_page();
  QDoubleSpinBox* limit(const char* name, const char* object, const char* suffix, int decimals);
  bool turns() const;  ///< it has motors for torque
  void show_limits();
  void describe();

  MeasureSubject subject_;
  QElapsedTimer since_end_;  ///< of what ran
  QStackedWidget* pages_;
  QFormLayout* form_ = nullptr;
  QLabel *ended_, *what_, *now_, *found_, *saved_;
  QComboBox* profiles_;
  QDoubleSpinBox *force_, *torque_, *travel_, *turn_;
  QProgressBar* bar_;
  QTableWidget* table_;
  QPushButton* use_;
};

}  // namespace sonde::ui
