// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <QString>
#include <QStringList>
#include <QTimer>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "ui/actions/prompts.hpp"
#include "ui/document/document.hpp"
#include "ui/document/file_watch.hpp"
#include "ui/document/recovery.hpp"
#include "ui/views/drawn_session.hpp"

namespace sonde::ui {

class Opener;
class Viewport;

/// Everything about the document as a whole: opening, saving, leaving, recovering, following
/// changes on disk; and the commands that change it (document_commands.cpp).
class DocumentControl : public QObject {
  Q_OBJECT
 public:
  /// The view, whose camera is kept with what is open.
  DocumentControl(Opener& opener, Prompts& prompts, const Viewport& view);

  Document& document() { return document_; }

  // What leaves the document that is open asks first, where there is anything to lose.
  void open(const QStringList& files, std::optional<double> unit);
  void ask_scene();
  bool ask_meshes(const QString& first = {});  ///< false: given up
  /// A scene, two meshes, or one mesh, which replaces a body.
  void drop(const QStringList& files);
  static bool is_one_mesh(const QStringList& files);
  void start_anew();  ///< nothing is open: the start page
  bool may_leave();   ///< false: stay

  bool save();
  bool save_as();

  /// Another session is open, or none.
  void attach(Session* session) { session_ = session; }
  /// Another document is shown.
  void opened(const Session& session);
  /// Offers the document that a program that died has left. False: there is none, or the user does
  /// not want it now.
  bool offer_recovery();
  /// What is not saved stays for the next program, which offers it: for an end without questions.
  void leave_to_recovery();

  // Commands.
  void start_from_here();
  void swap_bodies();
  void ask_bodies();  ///< units, axes, scales and models of the two that are open
  /// That body as in its file, or mended. One that has to be a solid need not be any more, where it
  /// is not mended.
  void set_repair(Role role, Repair repair);
  void make_solid(Role role);  ///< its openings are closed, and its inside counts
  void copy_pose();
  void copy_matrix();  ///< the same in NumPy's form
  void paste_pose();
  void place(const Pose& X_FM, const QString& what, bool mergeable = false);
  /// The probe was moved from that pose.
  void moved_from(const Pose& before, const QString& what, bool mergeable);
  void set_coupling(const Coupling& coupling);
  void set_device_settings(const DeviceSettings& settings);
  void set_knob(const ServoSettings& servo);  ///< the time of a tick, or its wanted accuracy

  // Of the fixed body's parts (part_commands.cpp). A body of one mesh becomes one of parts.
  void add_parts(const QStringList& files);  ///< each where its file has it, in that body's axes
  void remove_part(std::size_t part);
  void take_apart(std::size_t part);  ///< each component of its mesh becomes a part
  void rename_part(std::size_t part, const QString& name);
  void set_part_colour(std::size_t part, const QString& colour);  ///< "#e97d25"
  void set_part_shown(std::size_t part, bool shown);
  void set_part_felt(std::size_t part, bool felt);

 signals:
  /// The title, the recent files or what can be done has changed.
  void changed();
  void saved(const Scene& scene);  ///< as it is in its file now
  /// To be taken; may come while events are handled.
  void show_wanted(DrawnSession& drawn, bool same_document);
  void emptied();                       ///< nothing is open any more
  void place_wanted(const Pose& X_FM);  ///< the probe, at once
  void coupling_changed(const Coupling& coupling);
  void device_settings_changed(const DeviceSettings& settings);
  void look_wanted(const CameraPlace& place);
  void parts_changed(const std::vector<PartLook>& looks);  ///< of the fixed body
  void say(const QString& what);                           ///< in passing

 private:
  Content now() const;
  Pose here() const;  ///< X_FM, of the probe now
  void apply(const Content& from, const Content& to);
  void show_bodies(const Content& wanted);
  void note_index(int index);
  void show_what_was_not(const QString& reason);
  void change_bodies(const QString& what, const Content& wanted,
                     std::function<LoadedScene(const Progress&)> open);
  void replace_body(Role role, const QString& file);
  std::size_t components_in(std::size_t part) const;
  void change_parts(const QString& what, const std::function<void(SceneBody& fixed)>& change);
  void take_body(Role role, const QString& what, const std::function<void(SceneBody&)>& change);
  bool write(const std::filesystem::path& file);
  void watch();
  void file_changed(const QString& file);
  void file_vanished(const QString& file);
  void reload(const QString& file, const QString& what,
              std::function<LoadedScene(const Progress&)> open);
  void recover(const std::filesystem::path& file);
  void keep_for_recovery();
  Recovered for_recovery() const;
  std::string text_for_recovery() const;  ///< changes with whatever is kept
  QStringList files() const;

  Opener& opener_;
  Prompts& prompts_;
  const Viewport& view_;
  Session* session_ = nullptr;
  Document document_;
  std::optional<DrawnSession> ready_;      ///< of a command that is about to be done
  std::shared_ptr<const Bodies> on_show_;  ///< the bodies of the session
  std::optional<int> index_on_show_ = 0;   ///< of the undo stack, with these; none: it is gone
  bool showing_ = false;                   ///< others are being set up, after an undo or redo
  bool setup_failed_ = false;              ///< of those
  bool reading_scene_ = false;             ///< again, from its file
  FileWatch watch_;
  Recovery recovery_;
  QTimer recovery_timer_;
  std::string kept_;  ///< what recovery has, as text
};

}  // namespace sonde::ui
