// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// Several QtTest classes in one program, which links once: QTEST_..._MAIN takes a class up under the name of its file. Included before all
// else, as precompiled header.
#pragma once

#include <QCoreApplication>
#include <QTest>
#ifdef QT_WIDGETS_LIB
#include <QtWidgets>
#endif

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <memory>
#include <string>
#include <vector>

namespace hygroloom {

using TestMain = int (*)(int, char**);

/// Program.cpp runs it where its first argument is the file's name without folder and ending. Returns true.
bool take_up_test(const char* file, TestMain run);

template <typename Test> int run_test(int count, char** values)
{
    Test test;
    return QTest::qExec(&test, count, values);
}

/// With a QCoreApplication or QApplication.
template <typename Application, typename Test> int run_test_in(int count, char** values)
{
    QTest::Internal::callInitMain<Test>();
    const Application application(count, values);
    Application::setAttribute(Qt::AA_Use96Dpi, true);
    return run_test<Test>(count, values);
}

} // namespace hygroloom

#undef QTEST_APPLESS_MAIN
#undef QTEST_GUILESS_MAIN
#undef QTEST_MAIN
#define HYGROLOOM_TAKE_UP(number, run) static const bool taken_up_##number = hygroloom::take_up_test(__FILE__, run);
#define HYGROLOOM_TAKE_UP_AS(number, run) HYGROLOOM_TAKE_UP(number, run) // several tests may be compiled as one file
#define QTEST_APPLESS_MAIN(Test) HYGROLOOM_TAKE_UP_AS(__COUNTER__, hygroloom::run_test<Test>)
#define QTEST_GUILESS_MAIN(Test) HYGROLOOM_TAKE_UP_AS(__COUNTER__, (hygroloom::run_test_in<QCoreApplication, Test>))
#define QTEST_MAIN(Test) HYGROLOOM_TAKE_UP_AS(__COUNTER__, (hygroloom::run_test_in<QApplication, Test>))
