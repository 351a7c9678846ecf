// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// The views look as they did: each is compared with a picture of before in tests/data/pictures. packaging/make-pictures.sh takes these
// anew. Needs a display: xvfb-run.
#include "small_png.h"
#include "ui/basics/language.h"
#include "ui/garment/garment_edits.h"
#include "ui/results/live_panel.h"
#include "window_test.h"

#include <QDir>
#include <QDockWidget>
#include <QElapsedTimer>
#include <QPainter>
#include <QScreen>
#include <QTranslator>

using namespace hygroloom;

namespace {

const QString before = HYGROLOOM_SOURCE_DIR "/tests/data/pictures/";
constexpr QSize window_size{1280, 772}, compared_size{640, 386}; // of a screen of 800 lines less a title bar
constexpr int most_bytes = 60000;                                // of a picture of before
constexpr int same_grey = 24;                                    // levels of 256: letters are smoothed otherwise by other libraries
constexpr double most_changed = 0.02; // share of the pixels; times that are estimated differ from machine to machine

constexpr std::pair<const char*, Workspace> workspaces[] = {{"design", Workspace::design},
                                                            {"simulate", Workspace::simulate},
                                                            {"compare", Workspace::compare},
                                                            {"study", Workspace::study},
                                                            {"garment", Workspace::garment}};

double changed_share(const QImage& now, const QImage& then)
{
    const QImage a = now.convertToFormat(QImage::Format_Grayscale8), b = then.convertToFormat(QImage::Format_Grayscale8);
    if (a.size() != b.size()) { return 1; }
    long changed = 0;
    for (int y = 0; y < a.height(); ++y) {
        for (int x = 0; x < a.width(); ++x) { changed += std::abs(qGray(a.pixel(x, y)) - qGray(b.pixel(x, y))) > same_grey; }
    }
    return static_cast<double>(changed) / (static_cast<double>(a.width()) * a.height());
}

} // namespace

class TestPictures : public WindowTest {
    Q_OBJECT

private Q_SLOTS:
    void initTestCase() { useOwnSettings(); }
    void cleanup()
    {
        window_.reset();
        for (QTranslator* translator : qApp->findChildren<QTranslator*>()) {
            QCoreApplication::removeTranslator(translator);
            delete translator;
        }
        QSettings().clear();
    }

    void viewsLookAsBefore_data()
    {
        QTest::addColumn<QString>("language");
        QTest::addColumn<int>("look");
        for (const QString& language : {QString("en"), QString("de")}) {
            for (const auto& [name, look] : {std::pair("light", Appearance::light), {"dark", Appearance::dark}}) {
                QTest::addRow("%s-%s", qPrintable(language), name) << language << static_cast<int>(look);
            }
        }
    }
    void viewsLookAsBefore()
    {
        QFETCH(QString, language);
        QFETCH(int, look);
        open(language, static_cast<Appearance>(look));
        const QString which = QString("%1-%2x").arg(QTest::currentDataTag()).arg(window_->devicePixelRatio());
        QStringList changed;
        compare(which + "-start", changed);
        window_->openShippedExample();
        for (const auto& [name, workspace] : workspaces) {
            window_->setWorkspace(workspace);
            if (workspace == Workspace::garment) {
                window_->run().garment().choice().setGarmentIndex(addBuiltInGarment(window_->document(), "tee"));
            }
            compare(which + "-" + name, changed);
        }
        QVERIFY2(changed.isEmpty(), qPrintable(changed.join("; ") + ". What was seen lies in " + seen().path()));
    }

    void aPanelThatIsClosedIsSeen()
    {
        open("en", Appearance::light);
        window_->openShippedExample();
        const QImage with = picture();
        for (QDockWidget* dock : window_->findChildren<QDockWidget*>()) {
            if (dock->isVisible()) {
                dock->close();
                break;
            }
        }
        QVERIFY(changed_share(picture(), with) > most_changed);
    }

private:
    void open(const QString& language, Appearance look)
    {
        QSettings().setValue("look/language", language);
        install_language(*qApp);
        applyAppearance(look);
        openWindow(window_size);
    }
    static QDir seen()
    {
        const QDir folder(QDir::tempPath() + "/hygroloom-pictures");
        folder.mkpath(".");
        return folder;
    }
    /// From the screen, at rest: the same twice.
    QImage picture()
    {
        constexpr int rest_ms = 350, limit_ms = 20000;
        const auto grab = [this] {
            QPixmap all = window_->screen()->grabWindow(window_->winId());
            if (const auto* live = window_->findChild<LivePanel*>(); live && live->isVisible()) { // how far it came depends on the machine
                QPainter(&all).fillRect(QRect(live->mapTo(window_.get(), QPoint()), live->size()), Qt::gray);
            }
            return all.toImage()
                .convertToFormat(QImage::Format_RGB32)
                .scaled(compared_size, Qt::IgnoreAspectRatio, Qt::SmoothTransformation);
        };
        QElapsedTimer clock;
        clock.start();
        QTest::qWait(rest_ms);
        QImage now = grab();
        for (QImage last; clock.elapsed() < limit_ms && last != now;) {
            last = now;
            QTest::qWait(rest_ms);
            now = grab();
        }
        return now;
    }
    void compare(const QString& name, QStringList& changed)
    {
        const QString file = before + name + ".png";
        const QImage now = picture();
        const bool taken_anew = qEnvironmentVariableIsSet("HYGROLOOM_TAKE_PICTURES");
        const double share = taken_anew ? 0 : changed_share(now, QImage(file));
        if (share > most_changed) {
            now.save(seen().filePath(name + ".png"));
            changed << QString("%1: %2 % of the pixels are others").arg(name).arg(100 * share, 0, 'f', 1);
        }
        if (!taken_anew) { return; }
        QFile out(file);
        QVERIFY(out.open(QIODevice::WriteOnly));
        QVERIFY(out.write(smallPng(now, most_bytes)) > 0);
    }
};

QTEST_MAIN(TestPictures)
#include "tst_pictures.moc"
