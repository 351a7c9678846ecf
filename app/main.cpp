// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// The window. Opens the project or recording named on the command line, or the shipped example.
#include "core/run/learned_times.h"
#include "ui/basics/appearance.h"
#include "ui/window/main_window.h"

#include <QApplication>
#include <QCommandLineParser>

int main(int argc, char* argv[])
{
    hygroloom::requestOpenGL();

    QApplication application(argc, argv);
    QApplication::setApplicationName("hygroloom");
    QApplication::setApplicationDisplayName("Hygroloom");
    QApplication::setOrganizationName("hygroloom");
    QApplication::setApplicationVersion(HYGROLOOM_VERSION);
    QApplication::setDesktopFileName("hygroloom");

    QCommandLineParser parser;
    parser.setApplicationDescription(QApplication::translate("main", "Design woven fabrics and simulate how they take up water."));
    parser.addHelpOption();
    parser.addVersionOption();
    parser.addPositionalArgument("file", QApplication::translate("main", "A project (.hygro) or a recording (.hygrorec)."), "[file]");
    parser.process(application);

    hygroloom::keep_learned_times(hygroloom::usual_learned_times());
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
    window.offerLeftOver();
    return QApplication::exec();
}
