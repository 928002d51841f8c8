// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/panels/plots_panel.hpp"

#include <QCheckBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QMenu>
#include <QToolButton>
#include <QVBoxLayout>
#include <QVariant>
#include <algorithm>
#include <cmath>

#include "ui/base/theme.hpp"

namespace sonde::ui {
namespace {

constexpr qint64 draw_ms = 100;

}  // namespace

PlotsPanel::PlotsPanel(QWidget* parent) : QDockWidget(QStringLiteral("Plots"), parent) {
  setObjectName(QStringLiteral("plots_panel"));
  auto* content = new QWidget(this);
  auto* layout = new QVBoxLayout(content);
  layout->setContentsMargins(6, 2, 6, 4);
  layout->setSpacing(2);
  auto* row = new QHBoxLayout;
  layout->addLayout(row);
  auto* curves = new QToolButton(content);
  curves->setObjectName(QStringLiteral("curves"));
  curves->setText(QStringLiteral("Curves"));
  curves->setPopupMode(QToolButton::InstantPopup);
  auto* menu = new QMenu(curves);
  build_menu(*menu);
  curves->setMenu(menu);
  row->addWidget(curves);
  follow_ = new QCheckBox(QStringLiteral("Follow"), content);
  follow_->setObjectName(QStringLiteral("follow"));
  follow_->setToolTip(QStringLiteral("Keeps the shown tick in the picture"));
  follow_->setChecked(true);
  row->addWidget(follow_);
  hold_ = new QCheckBox(QStringLiteral("Hold"), content);
  hold_->setObjectName(QStringLiteral("hold_plots"));
  hold_->setToolTip(QStringLiteral("Draws nothing new; the servo goes on"));
  row->addWidget(hold_);
  values_ = new QLabel(content);
  values_->setObjectName(QStringLiteral("plot_values"));
  values_->setTextInteractionFlags(Qt::TextSelectableByMouse);
  values_->setTextFormat(Qt::RichText);
  row->addWidget(values_, 1);
  charts_ = new TimeCharts(content);
  layout->addWidget(charts_, 1);
  connect(charts_, &TimeCharts::clicked, this, &PlotsPanel::sought);
  connect(charts_, &TimeCharts::hovered, this, [this](double time) {
    hovered_ = time;
    read_out(time);
  });
  connect(charts_, &TimeCharts::dragged, this, [this](double seconds) {
    follow_->setChecked(false);
    from_ += seconds;
    to_ += seconds;
    dirty_ = true;
  });
  connect(charts_, &TimeCharts::zoomed, this, &PlotsPanel::zoom);
  setWidget(content);
}

void PlotsPanel::build_menu(QMenu& menu) {
  const std::vector<CurveStyle> styles = curve_styles(unit_);
  for (const CurveStyle& style : styles) {
    QAction* action = menu.addAction(style.name);
    action->setObjectName(QStringLiteral("curve_%1").arg(static_cast<int>(style.curve)));
    action->setCheckable(true);
    connect(action, &QAction::toggled, this, [this] { dirty_ = true; });
    shown_[static_cast<std::size_t>(style.curve)] = action;
  }
  for (const Curve first : {Curve::held, Curve::nearest, Curve::force, Curve::tick_us})
    set_shown(first, true);
}

void PlotsPanel::set_shown(Curve curve, bool on) {
  shown_[static_cast<std::size_t>(curve)]->setChecked(on);
}

bool PlotsPanel::shown(Curve curve) const {
  return shown_[static_cast<std::size_t>(curve)]->isChecked();
}

bool PlotsPanel::follows() const { return follow_->isChecked(); }

void PlotsPanel::take(const LengthUnit& unit) {
  unit_ = unit;
  hovered_.reset();
  state_ = {};
  from_ = 0;
  to_ = first_span;
  follow_->setChecked(true);
  dirty_ = true;
}

/// About the right end while that follows.
void PlotsPanel::zoom(double factor, double about) {
  const double span = std::clamp((to_ - from_) * factor, shortest_span, longest_span);
  const double part = follows() ? 1 : std::clamp((about - from_) / (to_ - from_), 0.0, 1.0);
  from_ = from_ + part * (to_ - from_ - span);
  to_ = from_ + span;
  dirty_ = true;
}

void PlotsPanel::follow() {
  const double span = to_ - from_;
  const bool inside = state_.time >= from_ && state_.time <= to_;
  const bool newest = state_.kept && state_.time >= state_.kept->last_time();
  if (inside && !newest) return;  // looking back: the cursor moves, not the picture
  to_ = newest ? state_.time : state_.time + span / 2;
  from_ = to_ - span;
}

void PlotsPanel::show_state(const PlotState& state, qint64 now) {
  if (!isVisible() || hold_->isChecked() || now < due_) return;
  // Another theme wants another picture, also of what rests.
  const QVariant light = is_light(palette());
  if (property("light") != light) setProperty("light", light), dirty_ = true;
  const bool changed = state.kept != state_.kept || state.replay != state_.replay ||
                       state.second != state_.second || state.time != state_.time || dirty_;
  if (!changed) return;
  due_ = now + draw_ms;
  dirty_ = false;
  state_ = state;
  if (follows()) follow();
  charts_->draw(view());
  ++drawn_;
  read_out(hovered_.value_or(state_.time));
}

ChartView PlotsPanel::view() const {
  ChartView view{.lines = {}, .from = from_, .to = to_, .cursor = state_.time, .unit = unit_};
  for (std::size_t i = 0; i < curve_count; ++i) {
    if (!shown_[i]->isChecked() || !state_.kept) continue;
    view.lines.push_back({state_.kept, static_cast<Curve>(i)});
    if (state_.replay)
      view.lines.push_back({state_.replay, static_cast<Curve>(i), ChartLine::Stroke::dashed});
    if (state_.second)
      view.lines.push_back({state_.second, static_cast<Curve>(i), ChartLine::Stroke::dotted});
  }
  return view;
}

void PlotsPanel::read_out(double time) {
  if (!state_.kept) return values_->clear();
  QStringList texts{QStringLiteral("%1 s").arg(time, 0, 'f', 3)};
  for (const CurveStyle& style : curve_styles(unit_)) {
    if (!shown(style.curve)) continue;
    const auto text = [&](const Curves& curves) {
      const double value = curves.at(style.curve, time);
      return std::isnan(value) ? QStringLiteral("–") : number(style.scale * value);
    };
    QString line = QStringLiteral("%1 %2").arg(
        in_colour(style.colour, QStringLiteral("━ ") + style.name), text(*state_.kept));
    if (state_.second)
      line += QStringLiteral(" / A %1 / B %2").arg(text(*state_.replay), text(*state_.second));
    else if (state_.replay)
      line += QStringLiteral(" / %1").arg(text(*state_.replay));
    texts.push_back(line + QLatin1Char(' ') + style.unit);
  }
  values_->setText(texts.join(QStringLiteral(" &nbsp; ")));
}

}  // namespace sonde::ui
