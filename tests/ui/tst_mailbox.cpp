// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// Work from other threads: in its order, and never ahead of all else.
#include "ui/basics/mailbox.h"

#include <QCoreApplication>
#include <QEvent>
#include <QEventLoop>
#include <QTest>

#include <algorithm>
#include <chrono>
#include <thread>

using namespace hygroloom;

namespace {

/// As windows are painted: after what is posted.
class Painted : public QObject {
public:
    int* done = nullptr;
    int at = -1;
    bool event(QEvent* event) override
    {
        if (event->type() == QEvent::User) { at = *done; }
        return QObject::event(event);
    }
};

} // namespace

class TestMailbox : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void worksComeInTheirOrder()
    {
        Mailbox box;
        std::vector<int> seen;
        std::jthread other([&] {
            for (int i = 0; i < 1000; ++i) {
                box.post([&seen, i] { seen.push_back(i); });
            }
        });
        QTRY_COMPARE(seen.size(), std::size_t(1000));
        QVERIFY(std::is_sorted(seen.begin(), seen.end()));
    }

    void theWindowIsPaintedBetweenThem()
    {
        Mailbox box;
        int done = 0;
        Painted painted;
        painted.done = &done;
        for (int i = 0; i < 100; ++i) {
            box.post([&done] {
                std::this_thread::sleep_for(std::chrono::milliseconds(5));
                ++done;
            });
        }
        QCoreApplication::postEvent(&painted, new QEvent(QEvent::User), Qt::LowEventPriority);
        QTRY_COMPARE(done, 100);
        QVERIFY2(painted.at >= 0 && painted.at < 10, qPrintable(QString::number(painted.at)));
    }

    void aWorkThatWaitsGetsWhatComesAfterIt()
    {
        Mailbox box;
        QEventLoop loop;
        bool after = false;
        box.post([&] { loop.exec(); });
        box.post([&] { loop.quit(); });
        box.post([&] { after = true; });
        QTRY_VERIFY(after);
        bool later = false;
        box.post([&] { later = true; });
        QTRY_VERIFY(later);
    }
};

QTEST_GUILESS_MAIN(TestMailbox)
#include "tst_mailbox.moc"
