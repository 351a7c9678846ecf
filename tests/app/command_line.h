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

/// cache: what is learned of this machine is kept there; usually nowhere.
inline Answer run_cli(const QStringList& arguments, int seconds = 120, const QString& cache = "/dev/null")
{
    QProcess process;
    auto environment = QProcessEnvironment::systemEnvironment();
    environment.insert("XDG_CACHE_HOME", cache);
    process.setProcessEnvironment(environment);
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
