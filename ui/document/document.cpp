// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/document/document.hpp"

#include <QUndoCommand>
#include <chrono>
#include <utility>

#include "engine/scene/write_scene.hpp"

namespace sonde::ui {
namespace {

using Clock = std::chrono::steady_clock;

constexpr int most_steps = 200;  // steps with other bodies keep those in memory
constexpr int merging_id = 2;    // unlike that of the coupling panel's commands
constexpr std::chrono::milliseconds quick_succession{700};

}  // namespace

class DocumentChange : public QUndoCommand {
 public:
  DocumentChange(Document& document, const QString& what, Content from, Content to, bool mergeable)
      : QUndoCommand(what),
        document_(document),
        from_(std::move(from)),
        to_(std::move(to)),
        mergeable_(mergeable),
        made_(Clock::now()) {}
  void redo() override { document_.apply(from_, to_); }
  void undo() override { document_.apply(to_, from_); }
  int id() const override { return mergeable_ ? merging_id : -1; }
  bool mergeWith(const QUndoCommand* other) override {
    const auto& next = static_cast<const DocumentChange&>(*other);
    if (next.text() != text() || next.made_ - made_ > quick_succession) return false;
    to_ = next.to_;
    made_ = next.made_;
    return true;
  }

 private:
  Document& document_;
  Content from_, to_;
  bool mergeable_;
  Clock::time_point made_;
};

Document::Document() { stack_.setUndoLimit(most_steps); }

void Document::open(Content content) {
  stack_.clear();
  content_ = std::move(content);
  text_.reset();
  saved_ = text();
}

void Document::close() {
  stack_.clear();
  content_ = {};
  text_.reset();
  saved_.clear();
}

void Document::change(const QString& what, const Content& wanted, bool mergeable) {
  stack_.push(new DocumentChange(*this, what, content_, wanted, mergeable));
}

void Document::apply(const Content& from, const Content& to) {
  // The file may have become another since: saving as is no step.
  std::filesystem::path file = content_.scene.file;
  std::string name = content_.scene.name;
  content_ = to;
  text_.reset();
  if (!file.empty()) {
    content_.scene.file = std::move(file);
    content_.scene.name = std::move(name);
  }
  emit changed(from, to);
}

void Document::save(const std::filesystem::path& file) {
  write_scene(content_.scene, file);
  content_.scene.file = file;
  content_.scene.name = name_of_scene(file);
  for (SceneBody* body : {&content_.scene.probe, &content_.scene.fixed})
    body->scene_file.clear();  // its lines are others now
  text_.reset();
  saved_ = text();
}

void Document::set_coupling(const Coupling& coupling) {
  content_.scene.coupling = coupling;
  text_.reset();
}

const std::string& Document::text() const {
  if (!text_) text_ = scene_text(content_.scene, "/");
  return *text_;
}

}  // namespace sonde::ui
