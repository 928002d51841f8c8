// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <QString>
#include <QUndoStack>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "engine/penetration/search/pair.hpp"
#include "engine/recording/recording_header.hpp"
#include "engine/scene/poses.hpp"
#include "engine/scene/scene.hpp"

namespace sonde::ui {

/// The contents of a scene's files when they were read.
struct Bodies {
  Pair pair;
  std::vector<TimedPose> trajectory;
  MeshMarks marks;
  std::vector<BodyPart> parts = {};  ///< LoadedScene::parts
};

/// The open content, as a value.
struct Content {
  Scene scene;  ///< what is saved
  Pose here;    ///< X_FM, the probe's present pose: part of undo and recovery, but not of the file
  std::shared_ptr<const Bodies> bodies;
};

/// The open scene: a value that undoable commands change, and that is saved and compared as a
/// value. It shows nothing and computes nothing; changed() reports each change.
class Document : public QObject {
  Q_OBJECT
 public:
  Document();

  bool empty() const { return content_.bodies == nullptr; }
  const Content& content() const { return content_; }
  /// Empty where it has never been saved.
  const std::filesystem::path& file() const { return content_.scene.file; }
  /// Returns whether the content differs from the file's; a moved probe alone does not count.
  bool modified() const { return !empty() && text() != saved_; }
  QUndoStack& stack() { return stack_; }

  /// Replaces the scene, with nothing to undo. As it is, it counts as saved.
  void open(Content content);
  /// The same for a recovered scene, whose file holds another text.
  void set_saved_text(std::string text) { saved_ = std::move(text); }
  const std::string& saved_text() const { return saved_; }
  void close();

  /// Executes one command. Commands of one kind (`what`) in quick succession, as a slider or a held
  /// key makes them, become one step where `mergeable`.
  void change(const QString& what, const Content& wanted, bool mergeable = false);
  /// Sets the probe's present pose, with nothing to undo.
  void set_here(const Pose& X_FM) { content_.here = X_FM; }
  /// Gains have commands of their own, on the same stack.
  void set_coupling(const Coupling& coupling);

  /// Writes the file, whole or not at all; it becomes the document's file. Throws InputError.
  void save(const std::filesystem::path& file);

  /// The scene as text, independent of its file: equal texts are equal scenes.
  const std::string& text() const;

 signals:
  /// With each command that is done, undone or redone; content() is already `to`.
  void changed(const Content& from, const Content& to);

 private:
  friend class DocumentChange;
  void apply(const Content& from, const Content& to);

  Content content_;
  std::string saved_;
  mutable std::optional<std::string> text_;  ///< of content_; none: not written yet
  QUndoStack stack_;
};

}  // namespace sonde::ui
