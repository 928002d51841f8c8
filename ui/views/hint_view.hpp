// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QColor>
#include <QPointF>
#include <QPolygonF>
#include <QString>
#include <QVariantAnimation>
#include <QWidget>
#include <array>
#include <vector>

#include "engine/geometry/pose.hpp"
#include "ui/views/colour_scale.hpp"
#include "ui/views/force_note.hpp"
#include "ui/views/legend_mark.hpp"

namespace sonde::ui {

/// A label, its point on screen, and the line there that it must not cover. Below its text stands
/// its note: what is wrong now as a warning, what a study says as plain text, and a small curve,
/// from 0 up, where it has a course.
struct PlacedLabel {
  QPointF at;
  QString text;
  QColor colour;
  QPolygonF stroke{};
  ForceNote note{};
};

/// All text in the view, drawn by Qt on a transparent sheet above the picture: the legend (colours
/// and lengths), labels beside arrows, a ruler, and how the mouse moves the probe.
class HintView : public QWidget {
 public:
  explicit HintView(QWidget* parent);

  void set_legend(std::vector<LegendLine> legend);
  void set_labels(std::vector<PlacedLabel> labels);
  /// A bar of that many pixels, with its length in words.
  void set_ruler(double pixels, const QString& text);
  /// One large line under the ruler: "Paused"; empty for none.
  void set_banner(const QString& text);
  const QString& banner() const { return banner_; }
  void set_hint_visible(bool visible);
  void set_legend_visible(bool visible);
  /// Hint and legend are on show even where they leave the bodies less than 45 % of the view, since
  /// they were asked for. At first they give way there: the hint first.
  void set_insists(bool insists) { insists_ = insists; }
  bool insists() const { return insists_; }
  /// Hint and legend go in half a second. What is laid out has their room at once.
  void fade();
  /// The axes of the fixed body as they are seen, unit: right, up and to the eye.
  void set_triad(const std::array<Vec3, 3>& axes);
  /// A column of colours at the right; none where there are no colours.
  void set_scale(ColourScale scale);

  /// The parts of the view without legend, ruler, banner or hint: below the legend, and beside it.
  /// The banner's place counts, whether or not there is a banner.
  std::vector<QRectF> clear_areas() const;

  /// The plates and marks that are on show, labels apart; none of them lies on another.
  std::vector<QRectF> boxes() const;

  static QString pause_banner();
  static QString stopped_banner();

  /// The keys that no menu lists, as "keys" and "what it does".
  static const std::vector<std::pair<QString, QString>>& keys();

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  struct Hint;
  Hint laid_out_hint() const;
  bool is_hint_on() const;
  bool is_legend_on() const;
  double room_beside(const QRectF& legend, double bottom) const;
  double hint_top() const;  ///< the view's bottom where there is no hint
  QRectF legend_plate() const;
  QRectF legend_box() const;
  QRectF ruler_box() const;
  QRectF banner_box(const QString& text) const;
  void draw_legend(QPainter& painter) const;
  void draw_hint(QPainter& painter, const Hint& hint) const;
  std::vector<QRectF> label_boxes() const;
  QRegion label_region() const;
  void draw_labels(QPainter& painter) const;
  void draw_ruler(QPainter& painter) const;
  void draw_banner(QPainter& painter) const;
  QRectF triad_box() const;
  void draw_triad(QPainter& painter) const;
  QRectF scale_box() const;
  void draw_colours(QPainter& painter) const;

  std::vector<LegendLine> legend_;
  std::vector<PlacedLabel> labels_;
  double ruler_pixels_ = 0;
  QString ruler_text_;
  QString banner_;
  ColourScale scale_;
  bool hint_visible_ = true, legend_visible_ = true, insists_ = false;
  bool hint_fades_ = false, legend_fades_ = false;
  std::array<Vec3, 3> triad_{};
  QVariantAnimation fading_;  ///< of both, while they are seen and do not count any more
};

}  // namespace sonde::ui
