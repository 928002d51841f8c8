// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/views/viewport.hpp"

#include <vtkProperty.h>

#include <QEvent>
#include <QImage>
#include <QOpenGLContext>
#include <QOpenGLFunctions>
#include <QResizeEvent>
#include <algorithm>
#include <array>
#include <iterator>
#include <string_view>
#include <vector>

#include "ui/base/theme.hpp"
#include "ui/views/scenery.hpp"

namespace sonde::ui {
namespace {

void set_background(vtkRenderer& renderer, bool light) {
  const QColor top = light ? colour::light_background_top : colour::background_top;
  const QColor bottom = light ? colour::light_background_bottom : colour::background_bottom;
  renderer.SetBackground(bottom.redF(), bottom.greenF(), bottom.blueF());
  renderer.SetBackground2(top.redF(), top.greenF(), top.blueF());
  renderer.SetBackgroundAlpha(1);  // VTK's own is none: a picture for a file would be transparent
}

QString describe(const char* role, const Body& body) {
  return QStringLiteral("%1 %2, %3, %4 triangles")
      .arg(QLatin1String(role), short_name(body),
           body.solid ? QStringLiteral("solid") : QStringLiteral("surface"))
      .arg(body.soup.triangles.size());
}

/// What the picture is of, where that is not what happens now.
QString banner_of(const Instant& now, bool for_file) {
  QString time = QStringLiteral("At %1 s").arg(now.snapshot.time, 0, 'f', 3);
  if (for_file && !now.live) return time;
  if (!now.live) return time + QStringLiteral(" – Space: live");
  if (now.snapshot.paused) return HintView::pause_banner();
  const bool stopped = now.snapshot.hand.withheld == Withheld::stopped;
  return stopped ? HintView::stopped_banner() : QString();
}

/// Does the processor draw, rather than a graphics card?
bool software_drawn(QVTKOpenGLNativeWidget& widget) {
  widget.makeCurrent();
  const QOpenGLContext* context = widget.context();
  if (!context) return true;
  const auto* name = reinterpret_cast<const char*>(context->functions()->glGetString(GL_RENDERER));
  const std::string_view renderer = name ? name : "";
  for (const std::string_view software : {"llvmpipe", "softpipe", "SWR", "Software"})
    if (renderer.find(software) != renderer.npos) return true;
  return false;
}

}  // namespace

Viewport::Viewport(QWidget* parent) : QWidget(parent), scenery_(std::make_unique<Scenery>(*this)) {
  setObjectName(QStringLiteral("viewport"));
  setMinimumSize(320, 240);
  Scenery& s = *scenery_;
  s.widget->setObjectName(QStringLiteral("canvas"));
  s.widget->setFocusPolicy(Qt::StrongFocus);
  setFocusProxy(s.widget);
  s.widget->setAcceptDrops(false);  // drops belong to the window
  s.window->SetMultiSamples(0);     // see show_bodies
  s.widget->setRenderWindow(s.window);
  s.widget->interactor()->SetInteractorStyle(nullptr);  // the mouse moves the probe, see MouseProbe
  s.window->SetNumberOfLayers(3);
  s.window->AddRenderer(s.bodies);
  for (int layer = 1; vtkRenderer * renderer : {s.above.Get(), s.top.Get()}) {
    s.window->AddRenderer(renderer);
    renderer->SetLayer(layer++);
    renderer->SetActiveCamera(s.bodies->GetActiveCamera());
    renderer->InteractiveOff();
  }
  s.bodies->GradientBackgroundOn();
  s.part_box->VisibilityOff();
  s.part_box->GetProperty()->SetColor(colour::chosen.redF(), colour::chosen.greenF(),
                                      colour::chosen.blueF());
  s.part_box->GetProperty()->SetLineWidth(2);
  s.part_box->GetProperty()->LightingOff();
  s.above->AddActor(s.part_box);
  apply_theme();
  s.hints->raise();
}

Viewport::~Viewport() = default;

void Viewport::show_bodies(const DrawnBodies& drawn, bool same_view) {
  Scenery& s = *scenery_;
  // Smoothing edges by samples triples the time of a picture that the processor draws.
  const bool software = s.software_drawn = software_drawn(*s.widget);
  s.window->SetMultiSamples(software ? 0 : 4);
  s.bodies->SetGradientBackground(!software);
  const Body &probe = drawn.pair->probe(), &fixed = drawn.pair->fixed();
  s.mass = probe.mass;
  s.unit = LengthUnit(s.mass.radius);
  s.centre = fixed.mass.com;
  s.q_FW = drawn.q_FW;
  s.last_device = s.last_separated = drawn.first;
  s.parts = drawn.parts;
  s.part_surface = drawn.part_surface;
  s.part_looks = drawn.part_looks;
  s.probe_surface = drawn.probe_surface;
  s.fixed_surface = drawn.fixed_surface;
  s.fixed_is_solid =
      s.parts.empty()
          ? fixed.solid
          : std::ranges::all_of(s.parts, [](const BodyPart& part) { return part.body->solid; });
  s.pair = drawn.pair;
  measure_scene();
  s.descriptions = {describe("probe", probe), describe("fixed", fixed)};

  s.detail.clear();
  s.movement.forget();
  if (s.fixed_actor) s.bodies->RemoveActor(s.fixed_actor);
  s.fixed_actor = body_actor(*s.bodies, *drawn.fixed_surface, colour::fixed, s.fixed_is_solid);
  s.probe = std::make_unique<ProbeView>(*s.bodies, *drawn.probe_surface, probe.solid);
  s.ghost = std::make_unique<GhostView>(*s.bodies, *drawn.probe_surface, probe.solid);
  const auto found = [&](FoundView::Way way, FoundView::Shape shape, const char* name,
                         const QColor& colour) {
    return std::make_unique<FoundView>(*s.bodies, *drawn.probe_surface, probe.solid, way, shape,
                                       QLatin1String(name), colour);
  };
  s.nearest =
      found(&BackgroundResult::nearest, FoundView::Shape::mesh, "nearest way out", colour::nearest);
  s.straight = found(&BackgroundResult::pdt, FoundView::Shape::wires, "PD_t", colour::straight);
  s.defects = std::make_unique<DefectView>(*s.bodies, drawn);
  s.caps = std::make_unique<CapView>(*s.bodies, drawn);
  simplify_surfaces();
  s.part_box->VisibilityOff();
  s.trail.clear();
  s.measures.clear();
  s.place.set({});
  apply_theme();
  s.probe_gaps.clear();
  s.fixed_gaps.clear();
  apply_layers();
  apply_seeing();
  set_coupling(drawn.coupling);

  if (same_view) return invalidate();
  // A scene's camera says where to look from; how near depends on the window's shape.
  const auto& place = drawn.camera;
  if (place)
    camera().look_at(place->target, place->position - place->target, place->up, 1);
  else
    look_by_default();
  fit();
}

void Viewport::set_coupling(const Coupling& coupling) {
  Scenery& s = *scenery_;
  s.wrench.set_scale(wrench_scale(s.mass.radius, coupling));
  update_legend();
  invalidate();
}

void Viewport::draw(const Instant& now, double swing) {
  Scenery& s = *scenery_;
  const Snapshot& snapshot = now.snapshot;
  if (!s.probe) return;
  s.last_device = snapshot.separation.device;
  s.last_separated = snapshot.separation.separated;
  const Vec3 com = s.last_device * s.mass.com;
  const Frame frame{snapshot,
                    s.mass,
                    s.unit,
                    metres_per_pixel(com),
                    swing,
                    searched_here(now),
                    float(s.window->GetSize()[1]) / float(std::max(view_size().height(), 1)),
                    clearance_here(now),
                    s.pair ? &*s.pair : nullptr};
  s.probe->show(frame);
  for (const auto& [layer, overlay] : s.overlays()) overlay->show(frame);
  s.sections.show(s.seeing.cut, s.last_device);
  // Room for the arrows too, which are about as long as the probe is large.
  const double away = std::max((com - s.centre).norm(),
                               (snapshot.separation.separated * s.mass.com - s.centre).norm());
  camera().clip_to(s.centre, std::max(s.radius, away + 3 * s.mass.radius));
  choose_detail(frame);
  s.window->Render();
  update_text(now);
  dirty_ = false;
}

void Viewport::draw_in_full(const Instant& now, double swing) {
  in_full_ = true;
  draw(now, swing);
  in_full_ = false;
}

/// A picture for a file is not one of those that follow each other in the window.
void Viewport::choose_detail(const Frame& frame) {
  Scenery& s = *scenery_;
  const bool of_window = !s.picture_size && !in_full_;
  const CameraPlace camera = place();
  if (of_window)
    s.movement.see(
        {camera.position, camera.target, camera.up, s.last_device, s.last_separated, frame.swing},
        s.mass.com, s.mass.radius, frame.pixel);
  s.detail.draw_simplified(of_window && s.movement.going_on());
}

bool Viewport::dirty() const { return dirty_ || (simplified() && !scenery_->movement.going_on()); }

bool Viewport::simplified() const { return scenery_->detail.simplified(); }

bool Viewport::simplified_made() const { return scenery_->detail.made(); }

void Viewport::update_text(const Instant& now) {
  Scenery& s = *scenery_;
  std::vector<PlacedLabel> labels;
  for (const auto& [layer, overlay] : s.overlays())
    for (const Label& label : overlay->labels())
      labels.push_back({on_screen(label.at), label.text, label.colour,
                        polygon_on_screen(label.stroke), label.note});
  s.hints->set_banner(banner_of(now, s.picture_size.has_value()));
  const double pixel = metres_per_pixel(s.last_device * s.mass.com);
  const double length = round_down_125(160 * pixel);
  s.hints->set_ruler(length / pixel, round_figure(length / s.unit.metres()) + ' ' + s.unit.name());
  s.hints->set_labels(std::move(labels));
  const ViewAxes axes = camera().axes();
  std::array<Vec3, 3> triad;
  for (int i = 0; i < 3; ++i) {
    const Vec3 axis = Vec3::Unit(i);
    triad.at(static_cast<std::size_t>(i)) = {axis.dot(axes.right), axis.dot(axes.up),
                                             axis.dot(axes.towards)};
  }
  s.hints->set_triad(triad);
}

void Viewport::set_shown(Layer layer, bool shown) {
  Scenery& s = *scenery_;
  s.shown[static_cast<std::size_t>(layer)] = shown;
  if (layer == Layer::hint) {
    s.hints->set_insists(shown);
    s.hints->set_hint_visible(shown);
    s.hints->set_legend_visible(shown);
    if (s.pair && is_as_fitted()) fit();
  }
  apply_layers();
  if (s.probe) update_legend();
  invalidate();
}

void Viewport::fade_hint() {
  Scenery& s = *scenery_;
  s.shown[static_cast<std::size_t>(Layer::hint)] = false;
  s.hints->fade();
  if (s.pair && is_as_fitted()) fit();  // into the room that this leaves
  invalidate();
}

bool Viewport::shown(Layer layer) const { return scenery_->shown[static_cast<std::size_t>(layer)]; }

void Viewport::apply_layers() {
  Scenery& s = *scenery_;
  for (const auto& [layer, overlay] : s.overlays())
    if (overlay) overlay->set_visible(shown(layer));
  if (s.caps) s.caps->set_ghost(shown(Layer::ghost));
}

void Viewport::set_handles_local(bool local) {
  scenery_->handles.set_local(local);
  invalidate();
}

std::optional<Handles> Viewport::handles(const Pose& X_FM) const {
  if (!shown(Layer::handles)) return std::nullopt;
  const Vec3& com = scenery_->mass.com;
  return handles_at(X_FM, com, scenery_->handles.local(),
                    HandleView::pixels * metres_per_pixel(X_FM * com));
}

/// The bodies keep their colours, which both backgrounds let see.
void Viewport::apply_theme() {
  Scenery& s = *scenery_;
  set_background(*s.bodies, is_light(palette()));
  std::vector<const vtkActor*> bodies{s.fixed_actor};
  if (s.probe) bodies.push_back(&s.probe->actor());
  if (s.caps) std::ranges::copy(s.caps->faces(), std::back_inserter(bodies));
  std::ranges::copy(s.sections.actors(), std::back_inserter(bodies));
  s.tone.apply(*s.bodies, palette(), bodies);
  for (vtkRenderer* glyphs : {s.above.Get(), s.top.Get()}) s.tone.apply(*glyphs, palette());
  invalidate();
}

void Viewport::changeEvent(QEvent* event) {
  QWidget::changeEvent(event);
  if (event->type() == QEvent::PaletteChange) apply_theme();
}

QWidget* Viewport::canvas() const { return scenery_->widget; }

QImage Viewport::picture() const { return scenery_->widget->grabFramebuffer(); }

QSurfaceFormat Viewport::surface_format() { return QVTKOpenGLNativeWidget::defaultFormat(); }

const char* Viewport::window_class() {
  return vtkSmartPointer<vtkRenderWindow>::New()->GetClassName();
}

void Viewport::resizeEvent(QResizeEvent* event) {
  QWidget::resizeEvent(event);
  scenery_->widget->setGeometry(rect());
  scenery_->hints->setGeometry(rect());
  invalidate();
  const QSize before = event->oldSize();
  if (!scenery_->pair || before.isEmpty()) return;
  // A dock that folds or unfolds covers nothing. Where one looks is the user's, unless that loses
  // sight of what was in it.
  if (is_as_fitted() || (shows_all(before) && !shows_all(size()))) fit();
}

}  // namespace sonde::ui
