// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <QUndoStack>
#include <filesystem>
#include <functional>
#include <memory>
#include <vector>

#include "engine/penetration/search/pair.hpp"
#include "engine/scene/poses.hpp"
#include "engine/scene/scene.hpp"

namespace sonde::ui {

/// What the files of a scene held when they were read.
struct Bodies {
  Pair pair;
  std::vector<TimedPose> trajectory;
};

/// All that is open, as a value.
struct Content {
  Scene scene;  ///< what is saved
  Pose here;    ///< X_FM, where the probe is: undone and recovered, but no part of the file
  std::shared_ptr<const Bodies> bodies;
};

/// The scene that is open: a value, changed by commands that can be undone, saved and compared as a
/// value. It shows nothing and computes nothing; who does hears of each change by changed().
class Document {
 public:
  Document();

  bool empty() const { return content_.bodies == nullptr; }
  const Content& content() const { return content_; }
  /// Empty where it was never saved.
  const std::filesystem::path& file() const { return content_.scene.file; }
  /// What a file would hold differs from what the file holds; a moved probe alone does not count.
  bool modified() const { return !empty() && text() != saved_; }
  QUndoStack& stack() { return stack_; }

  /// Another scene, with nothing to undo; as it is, it counts as saved.
  void open(Content content);
  /// The same again, of which the file holds other text: of one that was recovered.
  void set_saved_text(std::string text) { saved_ = std::move(text); }
  const std::string& saved_text() const { return saved_; }
  void close();

  /// One command. Commands of one kind (`what`) in quick succession, as a slider or a key that is
  /// held down makes them, are one step where `mergeable`.
  void change(const QString& what, const Content& wanted, bool mergeable = false);
  /// Where the probe is now, with nothing to undo.
  void set_here(const Pose& X_FM) { content_.here = X_FM; }
  /// Gains come with commands of their own, on the same stack.
  void set_coupling(const Coupling& coupling) { content_.scene.coupling = coupling; }

  /// Writes the file, whole or not at all, which is then that of the document. Throws InputError.
  void save(const std::filesystem::path& file);

  /// The scene as text, whatever file it is in: equal texts are equal scenes.
  std::string text() const;

  /// Called with each command done, undone or done again; content() is `to` by then.
  std::function<void(const Content& from, const Content& to)> changed;

 private:
  friend class DocumentChange;
  void apply(const Content& from, const Content& to);

  Content content_;
  std::string saved_;
  QUndoStack stack_;
};

}  // namespace sonde::ui
