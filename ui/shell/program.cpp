// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/shell/program.hpp"

#include <QApplication>
#include <QSurfaceFormat>
#include <QTimer>
#include <clocale>
#include <cstdlib>
#include <memory>
#include <string_view>
#include <utility>

#include "engine/base/error.hpp"
#include "ui/actions/document_control.hpp"
#include "ui/base/freed_memory.hpp"
#include "ui/base/resources.hpp"
#include "ui/base/terminal.hpp"
#include "ui/base/theme.hpp"
#include "ui/devices/device_control.hpp"
#include "ui/shell/arguments.hpp"
#include "ui/shell/demo.hpp"
#include "ui/shell/end_signals.hpp"
#include "ui/shell/main_window.hpp"
#include "ui/views/viewport.hpp"

namespace sonde::ui {
namespace {

constexpr int wrong_usage = 2, bad_input = 3, our_fault = 4, interrupted = 130;

bool is_set(const char* variable) {
  const char* value = std::getenv(variable);
  return value && *value;
}

/// Why no window can be drawn here; null where one can. Qt's offscreen platform would open a view
/// of no size and draw nothing, silently.
const char* no_display() {
  const char* platform = std::getenv("QT_QPA_PLATFORM");
  const std::string_view name = platform ? platform : "";
  for (const std::string_view blind : {"offscreen", "minimal", "linuxfb", "vnc"})
    if (name.starts_with(blind)) return "QT_QPA_PLATFORM names a platform without OpenGL; unset it";
  if (!is_set("DISPLAY") && !is_set("WAYLAND_DISPLAY"))
    return "no display: set DISPLAY, or start an X server such as Xvfb";
  return nullptr;
}

/// Qt aborts, with a core file, where the display cannot be opened. One line does.
void on_message(QtMsgType type, const QMessageLogContext& /*context*/, const QString& message) {
  for (const QString& line : message.split('\n')) tell_terminal(line.toStdString());
  if (type == QtFatalMsg) std::_Exit(our_fault);
}

QStringList files_to_open(const Arguments& arguments) {
  QStringList files;
  for (const std::string& file : arguments.files) files.push_back(QString::fromStdString(file));
  if (files.isEmpty()) files.push_back(resource(QStringLiteral("scenes/spoon-in-cup.sonde.json")));
  return files;
}

int picture_and_code(MainWindow& window, const std::string& file) {
  if (lit_share(window.viewport().picture()) <= 0) {
    tell_terminal("nothing was drawn");
    return our_fault;
  }
  return window.save_picture(QString::fromStdString(file)) ? 0 : bad_input;
}

/// What the command line wants done once its files are open.
void when_opened(MainWindow& window, const Arguments& arguments) {
  if (!arguments.demo.empty()) {
    auto* demo = new Demo(window, arguments.demo);
    demo->setParent(&window);
    QObject::connect(demo, &Demo::ended, demo, &QApplication::exit);
    demo->play();
  } else if (!arguments.screenshot.empty()) {
    // A moment for the servo's first ticks and the numbers.
    QTimer::singleShot(900, &window, [&window, file = arguments.screenshot] {
      QApplication::exit(picture_and_code(window, file));
    });
  }
}

void say(const QString& reason) { tell_terminal(reason.toStdString()); }

/// Nobody is there to ask: what is written goes to stderr, and what fails ends the program.
void answer_unattended(Prompts& prompts) {
  prompts.report_error = say;
  prompts.ask_bodies = [](const MeshPair&, const PairSetup& guess) { return std::optional(guess); };
  prompts.ask_paths = [](const QString& file, const QStringList& paths) {
    say(QStringLiteral("%1 names files outside of its folder: %2")
            .arg(file, paths.join(QStringLiteral(", "))));
    return Consent::once;  // as `sonde` reads it
  };
  prompts.ask_meshes = [](const QString&) -> std::optional<std::pair<QString, QString>> {
    say(QStringLiteral("one mesh alone: name the probe, then the fixed body"));
    return std::nullopt;
  };
}

/// What is opened first. Where it fails, a program that somebody looks at stays, with the reason on
/// its start page: whoever has double-clicked a file sees no terminal.
void open_command_line(MainWindow& window, const Arguments& arguments) {
  const Prompts interactive = window.prompts();
  const bool unattended = !arguments.demo.empty() || !arguments.screenshot.empty();
  if (unattended) answer_unattended(window.prompts());
  window.prompts().report_error = say;
  const QStringList files = files_to_open(arguments);
  const auto first = std::make_shared<bool>(true);
  QObject::connect(&window, &MainWindow::opened, &window,
                   [&window, arguments, interactive, unattended, first] {
                     if (!std::exchange(*first, false)) return;
                     if (!unattended) window.prompts() = interactive;
                     when_opened(window, arguments);
                   });
  QObject::connect(&window, &MainWindow::open_failed, &window,
                   [&window, interactive, unattended, files, first](const QString& reason) {
                     if (!std::exchange(*first, false)) return;
                     if (unattended) return QApplication::exit(bad_input);
                     window.prompts() = interactive;
                     if (reason.isEmpty())
                       window.show_start_page();  // cancelled by hand
                     else
                       window.show_start_page(reason, files);
                   });
  window.open(files, arguments.unit);
}

/// What is there first: what another run has left, the files of the command line, or the page to
/// begin from.
void begin(MainWindow& window, const Arguments& arguments) {
  if (arguments.demo.empty() && arguments.screenshot.empty()) {
    if (arguments.files.empty()) window.show_start_page();
    if (window.documents().offer_recovery() || arguments.files.empty()) return;
    window.clear_desk();
  }
  open_command_line(window, arguments);
}

/// What --device asks for holds the probe; an exit code where it cannot be found or opened.
std::optional<int> choose_device(MainWindow& window, const Arguments& arguments) {
  if (arguments.device.empty()) return {};
  try {
    window.devices().choose(find_source(arguments.device, device_profile_folders()));
    window.show_device_dock();
    if (arguments.demo.empty() || window.devices().mouse_leads()) return {};
    say(QStringLiteral(
        "--demo plays the mouse's part: it goes with the mouse or a simulated device"));
    return wrong_usage;
  } catch (const UnknownDevice& unknown) {
    say(QStringLiteral("--device: ") + QString::fromUtf8(unknown.what()));
    return wrong_usage;
  } catch (const InputError& bad) {
    say(QString::fromUtf8(bad.what()));
    return bad_input;
  }
}

}  // namespace

int run(int argc, char** argv) {
  const Parsed parsed = parse_arguments(argc, argv);
  if (parsed.exit_code) return *parsed.exit_code;
  if (const char* reason = no_display()) {
    tell_terminal(reason);
    return our_fault;
  }
  return_freed_memory();
  qInstallMessageHandler(on_message);
  QSurfaceFormat::setDefaultFormat(Viewport::surface_format());
  // Esc in a dialog of the system's own would never come by here, and the force would stay.
  QApplication::setAttribute(Qt::AA_DontUseNativeDialogs);
  QApplication::setAttribute(Qt::AA_EnableHighDpiScaling);  // by the screen's own density
  QApplication::setAttribute(Qt::AA_UseHighDpiPixmaps);
  QApplication application(argc, argv);
  std::setlocale(LC_NUMERIC, "C");  // else readers take "1.5" for 1 where the comma is decimal
  QLocale::setDefault(QLocale::c());
  QApplication::setOrganizationName(QStringLiteral("sonde"));
  QApplication::setApplicationName(QStringLiteral("sonde-view"));
  QApplication::setApplicationDisplayName(QStringLiteral("Sonde"));  // in the titles of dialogs
  apply_theme(application, chosen_theme());
  MainWindow window;
  when_told_to_end(&window, [&window] {
    window.documents().leave_to_recovery();
    QApplication::exit(interrupted);
  });
  const auto ask = std::exchange(window.prompts().report_error, say);
  if (const auto code = choose_device(window, parsed.arguments)) return *code;
  window.prompts().report_error = ask;
  window.show();
  // Through the event loop: a failure ends the loop, which must have begun.
  QTimer::singleShot(0, &window, [&window, &parsed] { begin(window, parsed.arguments); });
  return QApplication::exec();
}

}  // namespace sonde::ui
