// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/views/hint_view.hpp"

#include <QPaintEvent>
#include <QPainter>
#include <QPalette>
#include <algorithm>
#include <utility>

#include "ui/base/theme.hpp"
#include "ui/views/label_layout.hpp"

namespace sonde::ui {
namespace {

constexpr int margin = 14;
constexpr int fade_ms = 600;
constexpr double least_room = 0.45;   // share of the view that hint and legend leave to the bodies
constexpr double beside_legend = 36;  // pixels, for the marks and the edges
constexpr double course_width = 150, course_height = 34;  // pixels
const QColor plate(14, 17, 21, 165), light_plate(255, 255, 255, 240);

QFont small_font(const QWidget& widget) {
  QFont font = widget.font();
  font.setPointSizeF(9);
  return font;
}

QFont banner_font(const QWidget& widget) {
  QFont font = widget.font();
  font.setPointSizeF(12);
  font.setBold(true);
  return font;
}

void draw_plate(QPainter& painter, const QRectF& box, const QPalette& palette) {
  painter.setPen(Qt::NoPen);
  painter.setBrush(is_light(palette) ? light_plate : plate);
  painter.drawRoundedRect(box, 5, 5);
}

/// In the painter's pen, the largest value at the top.
void draw_course(QPainter& painter, const QRectF& box, const std::vector<double>& course) {
  const double largest = *std::ranges::max_element(course);
  const double last = std::max(double(course.size()) - 1, 1.0);
  QPolygonF line;
  for (std::size_t i = 0; i < course.size(); ++i)
    line << QPointF(box.left() + box.width() * double(i) / last,
                    box.bottom() - (largest > 0 ? course[i] / largest : 0) * box.height());
  painter.drawPolyline(line);
}

}  // namespace

HintView::HintView(QWidget* parent) : QWidget(parent) {
  setObjectName(QStringLiteral("hint_view"));
  setAttribute(Qt::WA_TransparentForMouseEvents);
  setAttribute(Qt::WA_NoSystemBackground);
  setFont(small_font(*this));
  fading_.setStartValue(1.0);
  fading_.setEndValue(0.0);
  fading_.setDuration(fade_ms);
  connect(&fading_, &QVariantAnimation::valueChanged, this, qOverload<>(&QWidget::update));
}

const std::vector<std::pair<QString, QString>>& HintView::keys() {
  static const std::vector<std::pair<QString, QString>> list{
      {"Drag", "moves the probe"},
      {"Wheel", "in depth"},
      {"Shift+drag", "turns it"},
      {"Ctrl+drag", "rolls it"},
      {"Arrows, PgUp, PgDn", "nudge it"},
      {"with Shift", "turn it"},
      {"Right drag", "orbits the view"},
      {"Middle drag", "pans"},
      {"Ctrl+wheel", "zooms"},
      {"Esc", "no force"},
  };
  return list;
}

void HintView::set_legend(std::vector<LegendLine> legend) {
  legend_ = std::move(legend);
  update();
}

void HintView::set_labels(std::vector<PlacedLabel> labels) {
  // Only where labels were and will be: painting the whole sheet anew costs a frame its share.
  QRegion changed = label_region();
  labels_ = std::move(labels);
  changed += label_region();
  update(changed);
}

void HintView::set_ruler(double pixels, const QString& text) {
  if (pixels == ruler_pixels_ && text == ruler_text_) return;
  ruler_pixels_ = pixels;
  ruler_text_ = text;
  update(0, 0, width(), 3 * margin + QFontMetrics(font()).height());
}

void HintView::set_banner(const QString& text) {
  if (text == banner_) return;
  banner_ = text;
  update();
}

void HintView::set_hint_visible(bool visible) {
  fading_.stop();
  hint_visible_ = visible;
  update();
}

void HintView::set_legend_visible(bool visible) {
  fading_.stop();
  legend_visible_ = visible;
  update();
}

void HintView::fade() {
  hint_fades_ = is_hint_on();
  legend_fades_ = is_legend_on();
  hint_visible_ = legend_visible_ = false;
  if (hint_fades_ || legend_fades_) fading_.start();
}

void HintView::set_triad(const std::array<Vec3, 3>& axes) {
  if (axes == triad_) return;
  triad_ = axes;
  update(triad_box().toAlignedRect().adjusted(-2, -2, 2, 2));
}

void HintView::set_scale(ColourScale scale) {
  if (scale.ticks == scale_.ticks && scale.title == scale_.title) return;
  scale_ = std::move(scale);
  update();
}

/// The pieces of the hint flow into lines, as words do; the plate grows upwards from the bottom.
struct HintView::Hint {
  struct Piece {
    QPointF at;  ///< from the plate's upper left
    const QString* text;
    QColor colour;
  };
  std::vector<Piece> pieces;
  QRectF plate;
};

/// A frame changes the labels alone: words elsewhere are not set anew for it.
void HintView::paintEvent(QPaintEvent* event) {
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  const auto touched = [event](const QRectF& box) {
    return event->region().intersects(box.toAlignedRect());
  };
  draw_labels(painter);
  const bool fading = fading_.state() == QAbstractAnimation::Running;
  if (fading) painter.setOpacity(fading_.currentValue().toDouble());
  if ((is_legend_on() || (fading && legend_fades_)) && touched(legend_plate()))
    draw_legend(painter);
  if (is_hint_on() || (fading && hint_fades_))
    if (const Hint hint = laid_out_hint(); touched(hint.plate)) draw_hint(painter, hint);
  painter.setOpacity(1);
  draw_triad(painter);
  draw_ruler(painter);
  draw_banner(painter);
  draw_colours(painter);
}

/// Where it would be, on show or not.
QRectF HintView::legend_plate() const {
  if (legend_.empty()) return {};
  const QFontMetricsF metrics(font());
  double width = 0;
  for (const LegendLine& entry : legend_)
    width = std::max(width, metrics.horizontalAdvance(entry.text));
  width = std::min(width + beside_legend, std::max(0.0, this->width() - 2.0 * margin));
  // Where there is no room beside the ruler, below it.
  const QRectF ruler = ruler_box();
  const bool beside = ruler.isEmpty() || margin + width < ruler.left() - 2 * margin;
  const double top = beside ? margin : ruler.bottom() + margin;
  return {margin, top, width, (metrics.height() + 2) * double(legend_.size()) + 10};
}

QRectF HintView::legend_box() const { return is_legend_on() ? legend_plate() : QRectF(); }

/// The hint first, since the legend names what is seen.
bool HintView::is_hint_on() const {
  return hint_visible_ && (insists_ || room_beside(legend_visible_ ? legend_plate() : QRectF(),
                                                   laid_out_hint().plate.top()) >= least_room);
}

bool HintView::is_legend_on() const {
  return legend_visible_ &&
         (insists_ || is_hint_on() || room_beside(legend_plate(), height()) >= least_room);
}

/// The share of the view below the legend, or right of it, down to `bottom`.
double HintView::room_beside(const QRectF& legend, double bottom) const {
  const double wide = std::max(1, width()), tall = std::max(1, height());
  return std::max((bottom - legend.bottom()) / tall,
                  (wide - legend.right()) / wide * (bottom / tall));
}

void HintView::draw_legend(QPainter& painter) const {
  if (legend_.empty()) return;
  const QFontMetricsF metrics(font());
  const double line = metrics.height() + 2;
  draw_plate(painter, legend_plate(), palette());
  double y = legend_plate().top() + 5;
  for (const LegendLine& entry : legend_) {
    draw_mark(painter, QRectF(margin + 9, y + line / 2 - 4.5, 9, 9), entry, palette());
    painter.setPen(palette().color(QPalette::WindowText));
    const double room = legend_plate().width() - beside_legend;  // the name of a body may be long
    painter.drawText(QPointF(margin + 27, y + metrics.ascent() + 1),
                     metrics.elidedText(entry.text, Qt::ElideMiddle, room));
    y += line;
  }
}

HintView::Hint HintView::laid_out_hint() const {
  const QFontMetricsF metrics(font());
  const double line = metrics.height() + 3, gap = 16, right = width() - margin - 10.0;
  Hint hint;
  double x = margin + 10, y = 4 + metrics.ascent();
  for (const auto& [key, action] : keys()) {
    const double key_width = metrics.horizontalAdvance(key) + 5;
    const double wide = key_width + metrics.horizontalAdvance(action);
    if (x + wide > right && x > margin + 10) {
      x = margin + 10;
      y += line;
    }
    hint.pieces.push_back({{x, y}, &key, palette().color(QPalette::WindowText)});
    hint.pieces.push_back({{x + key_width, y}, &action, faint_text(palette())});
    x += wide + gap;
  }
  const double tall = y + metrics.descent() + 7;
  hint.plate = {margin, height() - margin - tall, width() - 2.0 * margin, tall};
  return hint;
}

void HintView::draw_hint(QPainter& painter, const Hint& hint) const {
  draw_plate(painter, hint.plate, palette());
  for (const Hint::Piece& piece : hint.pieces) {
    painter.setPen(piece.colour);
    painter.drawText(piece.at + QPointF(0, hint.plate.top()), *piece.text);
  }
}

double HintView::hint_top() const { return is_hint_on() ? laid_out_hint().plate.top() : height(); }

std::vector<QRectF> HintView::clear_areas() const {
  const double bottom = hint_top();
  const QRectF legend = legend_box();
  const double under_banner = banner_box(pause_banner()).bottom();
  const auto between = [&](double left, double top) {
    return QRectF(QPointF(left, top), QPointF(width(), bottom)).adjusted(4, 4, -4, -4);
  };
  return {between(0, std::max(legend.bottom(), under_banner)),
          between(legend.right(), under_banner)};
}

std::vector<QRectF> HintView::boxes() const {
  std::vector<QRectF> taken{legend_box(), ruler_box(), banner_box(banner_), scale_box(),
                            triad_box()};
  if (is_hint_on()) taken.push_back(laid_out_hint().plate);
  std::erase_if(taken, [](const QRectF& box) { return box.isEmpty(); });
  return taken;
}

std::vector<QRectF> HintView::label_boxes() const {
  const QFontMetricsF metrics(font());
  std::vector<LabelToPlace> labels;
  for (const PlacedLabel& label : labels_) {
    QString all = label.text;
    for (const QString* line : {&label.note.now, &label.note.text})
      if (!line->isEmpty()) all += '\n' + *line;
    QSizeF size = metrics.size(0, all) + QSizeF(12, 4);
    if (!label.note.course.empty())
      size = {std::max(size.width(), course_width + 12), size.height() + course_height + 4};
    labels.push_back({label.at, label.text.isEmpty() ? QSizeF(0, 0) : size, label.stroke});
  }
  return place_labels(labels, boxes(), size());
}

QRegion HintView::label_region() const {
  QRegion region;
  for (const QRectF& box : label_boxes())
    if (!box.isEmpty()) region += box.toAlignedRect().adjusted(-1, -1, 1, 1);
  return region;
}

void HintView::draw_labels(QPainter& painter) const {
  const std::vector<QRectF> boxes = label_boxes();
  for (std::size_t i = 0; i < boxes.size(); ++i) {
    if (labels_[i].text.isEmpty() || boxes[i].isEmpty()) continue;
    draw_plate(painter, boxes[i], palette());
    const QColor own = readable(labels_[i].colour, palette());
    const ForceNote& note = labels_[i].note;
    QRectF line = boxes[i].adjusted(6, 2, 6, 0);
    const auto write = [&](const QString& text, const QColor& colour) {
      if (text.isEmpty()) return;
      painter.setPen(colour);
      painter.drawText(line, Qt::AlignLeft | Qt::AlignTop, text);
      line.setTop(line.top() + QFontMetricsF(font()).lineSpacing() * (1 + text.count('\n')));
    };
    write(labels_[i].text, own);
    write(note.now, readable(colour::force, palette()));
    write(note.text, palette().color(QPalette::WindowText));
    painter.setPen(own);
    if (!note.course.empty())
      draw_course(painter, boxes[i].adjusted(6, boxes[i].height() - course_height - 4, -6, -4),
                  note.course);
  }
}

QRectF HintView::ruler_box() const {
  if (!(ruler_pixels_ > 0)) return {};
  const double wide = std::max(ruler_pixels_, QFontMetricsF(font()).horizontalAdvance(ruler_text_));
  return {width() - margin - 4 - wide, margin, wide, QFontMetricsF(font()).height() + 14};
}

void HintView::draw_ruler(QPainter& painter) const {
  if (!(ruler_pixels_ > 0)) return;
  const QFontMetricsF metrics(font());
  const double right = width() - margin - 4;
  const double left = right - ruler_pixels_;
  const double y = ruler_box().bottom() - 2;
  draw_plate(painter, ruler_box().adjusted(-6, -4, 6, 4), palette());
  painter.setPen(QPen(palette().color(QPalette::WindowText), 2));
  painter.drawLine(QPointF(left, y), QPointF(right, y));
  painter.drawLine(QPointF(left, y - 5), QPointF(left, y));
  painter.drawLine(QPointF(right, y - 5), QPointF(right, y));
  const double wide = metrics.horizontalAdvance(ruler_text_);
  painter.drawText(QPointF((left + right - wide) / 2, y - 8), ruler_text_);
}

QString HintView::pause_banner() { return QStringLiteral("Paused – Space goes on"); }

QString HintView::stopped_banner() {
  return QStringLiteral("Force stopped – Ctrl+Space: force again");
}

QRectF HintView::banner_box(const QString& text) const {
  if (text.isEmpty()) return {};
  const QFontMetricsF metrics(banner_font(*this));
  const double wide = metrics.horizontalAdvance(text) + 20;
  const double left = width() - margin - wide;
  const QRectF legend = legend_box();
  const bool beside = legend.isEmpty() || legend.right() < left - margin;
  const double top =
      beside ? 2 * margin + QFontMetricsF(font()).height() + 14.0 : legend.bottom() + margin;
  return {left, top, wide, metrics.height() + 8};
}

void HintView::draw_banner(QPainter& painter) const {
  if (banner_.isEmpty()) return;
  const QRectF box = banner_box(banner_);
  draw_plate(painter, box, palette());
  painter.setFont(banner_font(*this));
  painter.setPen(readable(colour::contact, palette()));
  painter.drawText(box, Qt::AlignCenter, banner_);
  painter.setFont(font());
}

QRectF HintView::scale_box() const {
  const QSizeF size = scale_size(scale_, QFontMetricsF(font()));
  if (size.isEmpty()) return {};
  const double top = banner_box(pause_banner()).bottom() + margin;
  return {QPointF(width() - margin - size.width(), top), size};
}

void HintView::draw_colours(QPainter& painter) const {
  if (scale_.colours.empty()) return;
  draw_plate(painter, scale_box(), palette());
  painter.setPen(palette().color(QPalette::WindowText));
  draw_scale(painter, scale_box(), scale_);
}

}  // namespace sonde::ui
