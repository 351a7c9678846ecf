// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// The window. Opens the project or recording named on the command line, or the shipped example.
#include "core/project/atomic_file.h"
#include "core/room/kept_tables.h"
#include "core/run/learned_times.h"
#include "ui/basics/appearance.h"
#include "ui/basics/language.h"
#include "ui/basics/preferences.h"
#include "ui/results/report_file.h"
#include "ui/window/main_window.h"

#include <QApplication>
#include <QCommandLineParser>
#include <QTimer>

#include <algorithm>
#include <cstdio>
#include <string_view>

namespace {

/// Without a window: `hygroloom --pdf page.json page.pdf`. The command line writes its reports so.
int printPage(int argc, char* argv[])
{
    qputenv("QT_QPA_PLATFORM", "offscreen");
    qInstallMessageHandler([](QtMsgType type, const QMessageLogContext&, const QString& words) { // the others are of a screen
        if (type == QtFatalMsg) std::fputs((words.toStdString() + "\n").c_str(), stderr);
    });
    const QGuiApplication application(argc, argv);
    try {
        const std::string json = hygroloom::read_file(argv[2], std::size_t{256} << 20U);
        hygroloom::write_file(argv[3], hygroloom::pdfOf(hygroloom::page_from_json(json)));
        return 0;
    } catch (const std::exception& error) {
        std::fputs((std::string(error.what()) + "\n").c_str(), stderr);
        return 1;
    }
}

/// What only prints needs no screen. Without one Qt would abort.
bool preparesScreen(int argc, char* argv[])
{
    const auto is_given = [&](std::string_view word) { return std::find(argv + 1, argv + argc, word) != argv + argc; };
    for (const char* word : {"-h", "--help", "--help-all", "-v", "--version"})
        if (is_given(word)) qputenv("QT_QPA_PLATFORM", "offscreen");
    if (qEnvironmentVariableIsSet("QT_QPA_PLATFORM") || is_given("-platform") || !qEnvironmentVariableIsEmpty("DISPLAY") ||
        !qEnvironmentVariableIsEmpty("WAYLAND_DISPLAY"))
        return true;
    std::fputs("There is no screen to show a window on: neither DISPLAY nor WAYLAND_DISPLAY is set. hygroloom-cli needs none.\n", stderr);
    return false;
}

} // namespace

int main(int argc, char* argv[])
{
    if (argc == 4 && std::string_view(argv[1]) == "--pdf") return printPage(argc, argv);
    if (!preparesScreen(argc, argv)) return 1;
    hygroloom::requestOpenGL();

    QApplication application(argc, argv);
    QApplication::setApplicationName("hygroloom");
    QApplication::setApplicationDisplayName("Hygroloom");
    QApplication::setOrganizationName("hygroloom");
    QApplication::setApplicationVersion(HYGROLOOM_VERSION);
    QApplication::setDesktopFileName("hygroloom");
    hygroloom::install_language(application);

    QCommandLineParser parser;
    parser.setApplicationDescription(QApplication::translate("main", "Design woven fabrics and simulate how they take up water."));
    parser.addHelpOption();
    parser.addVersionOption();
    parser.addOption(
        {"pdf", QApplication::translate("main", "Write a report (.json) as PDF, without a window: --pdf page.json page.pdf.")});
    parser.addPositionalArgument("file", QApplication::translate("main", "A project (.hygro) or a recording (.hygrorec)."), "[file]");
    parser.process(application);

    hygroloom::keep_learned_times(hygroloom::usual_learned_times());
    hygroloom::keep_tables_in(hygroloom::usual_kept_tables());
    hygroloom::applyAppearance(hygroloom::savedAppearance());
    QApplication::setWindowIcon(hygroloom::themedIcon("hygroloom"));
    hygroloom::MainWindow window;
    window.show();
    const QStringList files = parser.positionalArguments();
    if (files.isEmpty()) {
        window.openShippedExample();
    } else {
        window.openFile(files.first());
    }
    const bool recovered = window.offerLeftOver();
    if (files.isEmpty() && !recovered && hygroloom::preferences().start_page != 0) {
        // After the first picture of the window.
        QTimer::singleShot(0, &window, &hygroloom::MainWindow::showStartPage);
    }
    return QApplication::exec();
}
