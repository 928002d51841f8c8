// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/panels/device_panel.hpp"

#include <QCheckBox>
#include <QComboBox>
#include <QFormLayout>
#include <QGroupBox>
#include <QLabel>
#include <QPushButton>
#include <QScrollArea>
#include <QSignalBlocker>
#include <QVBoxLayout>
#include <algorithm>
#include <string_view>

#include "engine/settings/settings.hpp"
#include "ui/base/format.hpp"
#include "ui/base/theme.hpp"
#include "ui/panels/axis_table.hpp"
#include "ui/panels/grip_box.hpp"
#include "ui/panels/scrolled.hpp"
#include "ui/panels/slider_row.hpp"
#include "ui/panels/source_words.hpp"

namespace sonde::ui {
namespace {

const QColor& colour_of(DeviceState state) {
  if (state == DeviceState::ready) return colour::ready;
  return state == DeviceState::silent ? colour::contact : colour::force;
}

/// A dock is as narrow as its other contents let it be: the longest name is no measure of that.
void bear_narrow(QComboBox& list) {
  list.setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
  list.setMinimumContentsLength(8);
}

}  // namespace

DevicePanel::DevicePanel(QWidget* parent) : QDockWidget(QStringLiteral("Device"), parent) {
  setObjectName(QStringLiteral("device_panel"));
  const auto [scroll, content, layout] = scrolled(*this);
  build_choice(*layout);
  build_state(*layout);
  grip_ = new GripBox(this);
  layout->addWidget(grip_);
  build_motion(*layout);
  build_loop(*layout);
  build_axes(*layout);
  layout->addStretch();
  show_settings(MouseSource{}, {});
  show_report(MouseSource{}, {});
}

void DevicePanel::build_choice(QVBoxLayout& layout) {
  auto* label = new QLabel(QStringLiteral("The probe is held by"), this);
  sources_ = new QComboBox(this);
  sources_->setObjectName(QStringLiteral("holder"));
  bear_narrow(*sources_);
  sources_->setToolTip(QStringLiteral(
      "The mouse itself, a recorded path, a simulated device that the mouse drives, or a "
      "connected device."));
  label->setBuddy(sources_);
  layout.addWidget(label);
  layout.addWidget(sources_);
  connect(sources_, qOverload<int>(&QComboBox::activated), this, [this](int i) {
    const auto at = static_cast<std::size_t>(i);
    if (at >= choices_.size()) return emit path_wanted();
    const InputSource wanted = choices_[at];  // who hears of it may list the choices anew
    emit chosen(wanted);
  });
}

QLabel* DevicePanel::number(QFormLayout& form, const char* name, const char* object,
                            const char* doc) {
  auto* label = new QLabel(text(name), form.parentWidget());
  auto* value = new QLabel(QStringLiteral("–"), form.parentWidget());
  value->setObjectName(text(object));
  value->setAlignment(Qt::AlignRight);
  label->setToolTip(text(doc));
  value->setToolTip(text(doc));
  form.addRow(label, value);
  return value;
}

void DevicePanel::build_state(QVBoxLayout& layout) {
  state_ = new QLabel(this);
  state_->setObjectName(QStringLiteral("device_state"));
  state_->setTextFormat(Qt::RichText);
  what_ = new QLabel(this);
  what_->setObjectName(QStringLiteral("device_reason"));
  what_->setWordWrap(true);
  what_->setTextFormat(Qt::PlainText);
  layout.addWidget(state_);
  layout.addWidget(what_);
  numbers_ = new QWidget(this);
  auto* form = new QFormLayout(numbers_);
  form->setContentsMargins(0, 4, 0, 0);
  form->setVerticalSpacing(3);
  rate_ = number(*form, "reports", "device_rate", "Reports a second, measured.");
  lost_ = number(*form, "lost", "device_lost",
                 "Reports missing by the device's own count, since it was opened.");
  refused_ = number(*form, "refused", "device_refused", "Reports that were impossible.");
  connections_ = number(*form, "opened", "device_connections", "How often it was opened.");
  latency_ = number(*form, "sample to force", "device_latency",
                    "From the arrival of a report to when the device has the force that answers it "
                    "(without motors: to when it is computed). The median, and what one in a "
                    "thousand exceeds.");
  clutch_ = number(*form, "clutch", "device_clutch", "Open: the probe stays where it is.");
  layout.addWidget(numbers_);
  led_ = new QCheckBox(QStringLiteral("Light"), this);
  led_->setObjectName(QStringLiteral("device_led"));
  connect(led_, &QCheckBox::toggled, this, &DevicePanel::led_switched);
  layout.addWidget(led_);
  measure_ = new QPushButton(QStringLiteral("Measure device…"), this);
  measure_->setObjectName(QStringLiteral("measure_device"));
  measure_->setToolTip(QStringLiteral(
      "Mass, damping, friction, delay and encoder step, by small pulses of force and torque. It "
      "asks first."));
  connect(measure_, &QPushButton::clicked, this, &DevicePanel::measure_asked);
  layout.addWidget(measure_);
}

void DevicePanel::build_motion(QVBoxLayout& layout) {
  motion_box_ = new QGroupBox(QStringLiteral("Motion"), this);
  auto* box = new QVBoxLayout(motion_box_);
  box->setContentsMargins(0, 4, 0, 0);
  from_scene_ = new QLabel(QStringLiteral("From the scene: changes last until another is opened, "
                                          "and are not kept for the device."),
                           motion_box_);
  from_scene_->setObjectName(QStringLiteral("settings_from_scene"));
  from_scene_->setWordWrap(true);
  box->addWidget(from_scene_);
  choices_row_ = new QWidget(motion_box_);
  auto* form = new QFormLayout(choices_row_);
  form->setContentsMargins(0, 0, 0, 0);
  const auto combo = [&](const char* name, const char* object, std::span<const Choice> choices) {
    auto* list = new QComboBox(choices_row_);
    list->setObjectName(text(object));
    bear_narrow(*list);
    int i = 0;
    for (const Choice& choice : choices) {
      list->addItem(text(choice.label));
      list->setItemData(i++, text(choice.doc), Qt::ToolTipRole);
    }
    form->addRow(text(name), list);
    return list;
  };
  controls_ = combo("a deflection is", "device_control", device_controls());
  frames_ = combo("its axes are", "device_frame", device_frames());
  connect(controls_, qOverload<int>(&QComboBox::activated), this, [this](int i) {
    change([i](DeviceSettings& s) { s.control = static_cast<DeviceSettings::Control>(i); });
  });
  connect(frames_, qOverload<int>(&QComboBox::activated), this, [this](int i) {
    change([i](DeviceSettings& s) { s.frame = static_cast<DeviceSettings::Frame>(i); });
  });
  box->addWidget(choices_row_);
  for (const Setting& setting : device_settings()) {
    auto* row = new SliderRow(setting, motion_box_);
    connect(row, &SliderRow::changed, this, [this, row](double value) {
      change([&](DeviceSettings& s) { set(s, row->setting().key, value); });
    });
    rows_.push_back(row);
    box->addWidget(row);
  }
  layout.addWidget(motion_box_);
}

void DevicePanel::build_loop(QVBoxLayout& layout) {
  auto* group = new QGroupBox(QStringLiteral("Loop"), this);
  auto* box = new QVBoxLayout(group);
  box->setContentsMargins(0, 4, 0, 0);
  rate_row_ = new SliderRow(*find_setting(servo_settings(), "rate_hz"), group);
  connect(rate_row_, &SliderRow::changed, this,
          [this](double value) { change([&](DeviceSettings& s) { s.rate_hz = value; }); });
  box->addWidget(rate_row_);
  const Setting& control = *find_setting(servo_settings(), "passivity_control");
  passivity_ = new QCheckBox(text(control.label), group);
  passivity_->setObjectName(text(control.key));
  passivity_->setToolTip(QStringLiteral(
      "Damps away the energy that the loop gives to a force device; off, it only observes it."));
  connect(passivity_, &QCheckBox::toggled, this,
          [this](bool on) { change([&](DeviceSettings& s) { s.passivity_control = on; }); });
  box->addWidget(passivity_);
  auto* numbers = new QWidget(group);
  auto* form = new QFormLayout(numbers);
  form->setContentsMargins(0, 0, 0, 0);
  form->setVerticalSpacing(3);
  form->addRow(new QLabel(QStringLiteral("Energy, observed always"), numbers));
  given_ = number(*form, "given to the hand", "energy_given",
                  "Net work on the hand since the start; below zero, the hand gave energy.");
  excess_ = number(*form, "in excess", "energy_excess",
                   "Energy of contacts beyond what the device takes out; above zero they are not "
                   "passive.");
  dissipated_ =
      number(*form, "taken out", "energy_dissipated", "By the passivity control, since the start.");
  box->addWidget(numbers);
  real_time_ = new QLabel(group);
  real_time_->setObjectName(QStringLiteral("real_time"));
  real_time_->setWordWrap(true);
  real_time_->setForegroundRole(QPalette::PlaceholderText);
  real_time_->setToolTip(QStringLiteral("What the system grants to the thread of the loop"));
  box->addWidget(real_time_);
  layout.addWidget(group);
}

void DevicePanel::build_axes(QVBoxLayout& layout) {
  axes_box_ = new QGroupBox(QStringLiteral("Axes"), this);
  auto* box = new QVBoxLayout(axes_box_);
  box->setContentsMargins(0, 4, 0, 0);
  for (const Setting& setting : axis_settings()) {
    auto* row = new SliderRow(setting, axes_box_);
    row->setToolTip(text(setting.doc) + QStringLiteral(" This sets all six."));
    connect(row, &SliderRow::changed, this, [this, row](double value) {
      change([&](DeviceSettings& s) {
        for (AxisSetting& axis : s.axes.axes) set(axis, row->setting().key, value);
      });
    });
    axis_rows_.push_back(row);
    box->addWidget(row);
  }
  axes_ = new AxisTable(axes_box_);
  connect(axes_, &AxisTable::changed, this,
          [this](const AxisMap& axes) { change([&](DeviceSettings& s) { s.axes = axes; }); });
  box->addWidget(axes_);
  auto* defaults = new QPushButton(QStringLiteral("Defaults"), axes_box_);
  defaults->setObjectName(QStringLiteral("device_defaults"));
  connect(defaults, &QPushButton::clicked, this,
          [this] { change([this](DeviceSettings& s) { s = usual_; }); });
  box->addWidget(defaults);
  layout.addWidget(axes_box_);
}

void DevicePanel::change(const std::function<void(DeviceSettings&)>& how) {
  how(settings_);
  show_rows();
  emit settings_changed(settings_);
}

void DevicePanel::show_choices(const std::vector<InputSource>& choices,
                               const InputSource& current) {
  QStringList labels;
  for (const std::string& label : labels_of(choices)) labels << text(label);
  labels << QStringLiteral("A recorded path from a file …");
  const QSignalBlocker quiet(sources_);
  choices_ = choices;
  if (labels != labels_) {
    labels_ = labels;
    sources_->clear();
    sources_->addItems(labels_);
  }
  const auto now =
      std::ranges::find_if(choices_, [&](const InputSource& h) { return same(h, current); });
  sources_->setCurrentIndex(static_cast<int>(now - choices_.begin()));
}

void DevicePanel::show_settings(const InputSource& source, const DeviceSettings& settings,
                                bool from_scene) {
  connected_ = std::holds_alternative<ConnectedSource>(source);
  adjustable_ = connected_ || std::holds_alternative<SimulatedSource>(source);
  grip_->setVisible(adjustable_ && !connected_);
  settings_ = settings;
  usual_ = usual_settings(source);
  from_scene_->setVisible(adjustable_ && from_scene);
  show_rows();
}

void DevicePanel::show_rows() {
  motion_box_->setVisible(adjustable_);
  axes_box_->setVisible(connected_);
  choices_row_->setVisible(connected_);
  controls_->setCurrentIndex(static_cast<int>(settings_.control));
  controls_->setEnabled(deflections_);
  frames_->setCurrentIndex(static_cast<int>(settings_.frame));
  for (SliderRow* row : rows_) {
    const std::string_view key = row->setting().key;
    const bool always = key == "scaling";
    const bool for_both = always || key == "clutch_button";
    row->setVisible(always || (connected_ && (for_both || deflections_)));
    const double value = get(settings_, key);
    if (row->value() != value) row->set_value(value);
  }
  for (SliderRow* row : axis_rows_) {
    row->setVisible(deflections_ || std::string_view(row->setting().key) == "gain");
    row->set_value(get(settings_.axes.axes[0], row->setting().key));
  }
  axes_->show_axes(settings_.axes, deflections_);
}

void DevicePanel::show_servo(const ServoSettings& servo) {
  const QSignalBlocker quiet(passivity_);
  passivity_->setChecked(servo.passivity.control);
  if (rate_row_->value() != servo.rate_hz) rate_row_->set_value(servo.rate_hz);
}

void DevicePanel::show_real_time(const RealTime& granted) {
  QStringList lines;
  for (const char* words : {granted.scheduling, granted.memory, granted.processor})
    if (*words != 0) lines << text(words);
  const QString all =
      lines.isEmpty() ? QString() : QStringLiteral("The loop has: %1.").arg(lines.join("; "));
  if (real_time_->text() != all) real_time_->setText(all);
}

void DevicePanel::show_energy(const HandEnergy& energy) {
  const auto show = [](QLabel* label, double joules) {
    const QString number = QString::number(1e3 * joules, 'f', 1);
    // What rounds to nothing has no sign.
    label->setText((number.toDouble() == 0 ? QStringLiteral("0.0") : number) +
                   QStringLiteral(" mJ"));
  };
  show(given_, energy.given);
  show(excess_, energy.excess);
  show(dissipated_, energy.dissipated);
}

void DevicePanel::show_report(const InputSource& source, const SourceReport& report) {
  const DeviceStatus& device = report.device;
  numbers_->setVisible(connected_);
  state_->setVisible(connected_);
  led_->setVisible(connected_ && device.capabilities.led);
  measure_->setVisible(adjustable_ && !(connected_ && deflections_));
  measure_->setEnabled(report.measurable);
  const auto* simulated = std::get_if<SimulatedSource>(&source);
  what_->setText(simulated ? words_of(simulated->profile) : words_of(report));
  what_->setVisible(!what_->text().isEmpty());
  if (!connected_) return;
  if (deflections_ == device.capabilities.position) {
    deflections_ = !device.capabilities.position;
    show_rows();
  }
  state_->setText(QStringLiteral("<b>%1</b>")
                      .arg(in_colour(colour_of(device.state), text(name_of(device.state)))));
  rate_->setText(QString::number(report.reports_per_s, 'f', 0) + QStringLiteral(" Hz"));
  const auto of = [&](std::uint64_t count) {
    return QStringLiteral("%1 of %2").arg(count).arg(device.reports);
  };
  lost_->setText(QString::number(device.lost) + QStringLiteral(" reports"));
  refused_->setText(of(device.refused));
  connections_->setText(device.connections == 1
                            ? QStringLiteral("once")
                            : QStringLiteral("%1 times").arg(device.connections));
  const LatencySummary& latency = device.latency;
  const auto ms = [](double us) { return QString::number(us / 1000, 'f', 2); };
  latency_->setText(latency.samples == 0
                        ? QStringLiteral("–")
                        : ms(latency.median) + " ms, 99.9 % " + ms(latency.p999) + " ms");
  clutch_->setText(report.clutch_open ? QStringLiteral("open: the probe stays")
                                      : QStringLiteral("closed"));
}

}  // namespace sonde::ui
