// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QPolygonF>
#include <QSize>
#include <QSurfaceFormat>
#include <QWidget>
#include <memory>
#include <optional>
#include <vector>

#include "engine/body/body.hpp"
#include "engine/proximity/queries/gap_field.hpp"
#include "ui/document/handles.hpp"
#include "ui/document/instant.hpp"
#include "ui/document/loaded_scene.hpp"
#include "ui/views/camera.hpp"
#include "ui/views/drawn_bodies.hpp"
#include "ui/views/force_note.hpp"
#include "ui/views/measure_view.hpp"
#include "ui/views/seeing.hpp"

namespace sonde::ui {

struct Frame;

/// The layers of the view that can be shown or hidden.
enum class Layer {
  ghost,
  screw,
  contacts,
  wrench,
  nearest,
  straight,
  trail,
  hint,  ///< how the mouse moves the probe, and the legend
  handles,
  defects,
  gaps,       ///< colours of the gap
  cut,        ///< the cut plane's outline and handles, where there is a cut
  bound,      ///< the witness of the lower bound
  measures,   ///< points that were picked
  crossings,  ///< triangles that go through others of their mesh
  clearance,  ///< the nearest points of a probe that is free
  mended,     ///< what closes openings, and the place that is pointed out
  grid,       ///< on the ground
  stiffness,  ///< that the hand feels
};

/// A point of a body that is visible in the picture.
struct Pick {
  bool on_probe = false;
  Vec3 x;                                ///< in that body's mesh frame, m
  std::optional<std::size_t> part = {};  ///< of the fixed body, where that is of several
  Vec3 normal = Vec3::Zero();  ///< of the triangle, to the eye's side, unit; fixed body's frame
  /// Along the nearest of its sides where the surface has an edge, unit, in that frame; zero: none.
  Vec3 edge = Vec3::Zero();
  Vec3 on_edge = Vec3::Zero();  ///< a point of that, there
  std::uint32_t triangle = 0;   ///< of the body's soup, or of its part's
};

/// The gaps between the bodies, to paint on them.
struct Gaps {
  GapField probe, fixed;
  Pose separated;    ///< X_FM of the probe whose gaps they are
  double reach = 0;  ///< m, of the last colour
};

/// The settings of a picture for a file.
struct PictureOptions {
  QSize size{1920, 1080};    ///< pixels
  bool transparent = false;  ///< no background
  bool overlays = true;      ///< arrows, contacts, the ghost, and text
  double swing = 1;          ///< as of Viewport::draw
};

/// The 3-D view: the two bodies, the overlays above them, and the text above those. It draws when
/// told to, at most once a frame.
class Viewport : public QWidget {
 public:
  explicit Viewport(QWidget* parent = nullptr);
  ~Viewport() override;

  /// Takes new bodies and turns the camera to them, unless the camera should stay.
  void show_bodies(const DrawnBodies& drawn, bool same_view = false);
  /// The limits of the device changed: so do the scales of force and torque.
  void set_coupling(const Coupling& coupling);
  /// What stands below the force; a picture of the past has none.
  void set_force_note(const ForceNote& note);
  /// Draws one picture. `swing`: position of the ghost on its way, 1 at its end.
  void draw(const Instant& now, double swing);

  /// The same in full detail, also while something moves.
  void draw_in_full(const Instant& now, double swing);

  /// The camera was moved, or a layer toggled: the next frame must be drawn.
  void invalidate() { dirty_ = true; }
  /// Also where the last one was simplified, and nothing moves any more.
  bool dirty() const;
  /// Does the picture show large bodies in fewer triangles, because something moves?
  bool simplified() const;
  /// Whatever will be drawn simplified can be.
  bool simplified_made() const;

  void set_shown(Layer layer, bool shown);
  bool shown(Layer layer) const;

  /// Hint and legend go, not all at once.
  void fade_hint();

  /// Along the probe's own axes, rather than the fixed body's.
  void set_handles_local(bool local);
  /// The handles of a probe there, as they are drawn; none where they are not.
  std::optional<Handles> handles(const Pose& X_FM) const;

  void set_seeing(const Seeing& seeing);
  const Seeing& seeing() const;
  /// The handles of the cut plane as they are drawn; none where they are not.
  std::optional<Handles> cut_handles() const;
  /// Other looks of the fixed body's parts. Returns its surface as it is drawn now; null where it
  /// is of one mesh.
  vtkSmartPointer<vtkPolyData> show_parts(const std::vector<PartLook>& looks);
  /// Puts a box round that part of the fixed body.
  void choose_part(std::optional<std::size_t> part);
  /// Marks the contact of that cluster; 0: none.
  void choose_contact(std::uint64_t id);
  /// The nearest point of a body at a place in the view, in Qt's pixels; not on hidden or cut-away
  /// parts.
  std::optional<Pick> pick(QPointF at) const;
  void add_measured(const MeasuredPoint& point);
  void clear_measured();
  const std::vector<MeasuredPoint>& measured() const;
  void set_gaps(const Gaps& gaps);
  /// Triangles of the bodies' soups, in ascending order.
  void set_crossings(const std::vector<std::uint32_t>& probe,
                     const std::vector<std::uint32_t>& fixed);

  /// Puts a ring round a place, with its words; none: takes it away.
  void point_out(const std::optional<PointedPlace>& place);
  /// X_FB of a body's mesh frame as it was drawn last.
  Pose pose_of(bool probe) const;
  /// Where the eye would stand before such a place, with some of the body around it.
  CameraPlace before(const PointedPlace& place) const;

  Camera camera() const;
  void set_parallel(bool on);
  CameraPlace place() const;
  void look(const CameraPlace& place);
  void fit();
  /// The probe is somewhere else at once: where that is out of the picture, all is fitted into it.
  void find_probe(const Pose& X_FM);
  double metres_per_pixel(const Vec3& at) const;
  /// The place of a point of the scene in the view, in Qt's pixels from the upper left.
  QPointF on_screen(const Vec3& point) const;

  /// The widget that receives mouse and keyboard.
  QWidget* canvas() const;
  /// The picture as drawn by OpenGL, with no text.
  QImage picture() const;
  /// A picture of any size, with a limit for each side; null where there is nothing to draw, or no
  /// room for it. The window's own picture stays as it is.
  QImage picture(const Instant& now, const PictureOptions& options);
  static constexpr int largest_picture = 16'384;  ///< pixels: OpenGL's limit where Mesa draws
  /// The required format of OpenGL; make it the default before there is an application.
  static QSurfaceFormat surface_format();
  /// The class of window that VTK makes on this machine, for the test that it can draw at all.
  static const char* window_class();

 protected:
  void resizeEvent(QResizeEvent* event) override;
  void changeEvent(QEvent* event) override;  ///< another theme

 private:
  struct Scenery;
  void choose_detail(const Frame& frame);
  void simplify_surfaces();
  void measure_scene();
  void update_text(const Instant& now);
  void update_legend();
  void update_scale();
  void apply_layers();
  void apply_theme();
  bool is_as_fitted() const;
  bool shows_all(const QSize& size) const;
  void apply_seeing();
  void show_sections();
  void look_by_default();
  QPolygonF polygon_on_screen(const std::vector<Vec3>& points) const;
  double aspect() const;
  /// Of the picture that is being drawn, as text and glyphs are laid out.
  QSize view_size() const;

  std::unique_ptr<Scenery> scenery_;
  bool dirty_ = true;
  CameraPlace fitted_{Vec3::Zero(), Vec3::Zero(), Vec3::Zero()};  ///< where fit() put the camera
  bool in_full_ = false;                                          ///< what is being drawn
};

}  // namespace sonde::ui
