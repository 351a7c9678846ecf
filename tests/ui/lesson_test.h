// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// A lesson on screen for a test, its cloths laid out before each function.
#pragma once

#include "ui/basics/appearance.h"
#include "ui/document/document.h"
#include "ui/lesson/lesson_controls.h"
#include "ui/lesson/lesson_scene.h"
#include "ui/lesson/lesson_steps.h"
#include "ui/lesson/lesson_window.h"

#include <QTest>

namespace hygroloom {

class LessonTest : public QObject {
protected:
    static constexpr int patience = 120000; // ms

    static bool laidOut(LessonWindow& window)
    {
        for (int k = 0; k < window.table()->cloths(); ++k) {
            if (!window.table()->view(k)) { return false; }
        }
        return true;
    }

    static int dropsOn(LessonWindow& window, int cloth) { return window.table()->view(cloth)->score.drops; }

    void openLesson()
    {
        useResources();
        document_ = std::make_unique<Document>();
        window_ = std::make_unique<LessonWindow>(*document_);
        window_->resize(1280, 800);
        window_->show();
        QVERIFY(QTest::qWaitForWindowExposed(window_.get()));
        QTRY_VERIFY_WITH_TIMEOUT(laidOut(*window_), patience);
    }

    std::unique_ptr<Document> document_;
    std::unique_ptr<LessonWindow> window_;
};

} // namespace hygroloom
