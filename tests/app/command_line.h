// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// Runs hygroloom-cli as a script would.
#pragma once

#include <QJsonDocument>
#include <QJsonObject>
#include <QProcess>

struct Answer {
    int code = -1;
    QByteArray out;
    QByteArray err;
    QJsonObject json() const { return QJsonDocument::fromJson(out).object(); }
};

inline Answer run_cli(const QStringList& arguments, int seconds = 120)
{
    QProcess process;
    process.start(HYGROLOOM_CLI, arguments);
    Answer answer;
    if (!process.waitForFinished(1000 * seconds)) {
        process.kill();
        process.waitForFinished();
        return answer;
    }
    answer.code = process.exitStatus() == QProcess::NormalExit ? process.exitCode() : -2;
    answer.out = process.readAllStandardOutput();
    answer.err = process.readAllStandardError();
    return answer;
}

inline QString example(const char* name) { return QString(HYGROLOOM_SOURCE_DIR "/resources/examples/") + name; }
