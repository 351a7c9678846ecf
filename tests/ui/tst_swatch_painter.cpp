// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// Pictures of fabrics without a window: drawn once, found again, drawn anew when the fabric differs. Needs a display: xvfb-run.
#include "core/project/library.h"
#include "ui/picture/swatch_painter.h"

#include <QColorSpace>
#include <QColorTransform>
#include <QDir>
#include <QOpenGLFunctions>
#include <QTemporaryDir>
#include <QTest>

#include <thread>

using namespace hygroloom;

namespace {

constexpr int pixels = 96;

struct Spread {
    QColor mean;
    int range = 0; ///< of grey
};

Spread spreadOf(const QImage& picture)
{
    long sums[3] = {};
    int low = 255, high = 0;
    for (int y = 0; y < picture.height(); ++y) {
        for (int x = 0; x < picture.width(); ++x) {
            const QRgb at = picture.pixel(x, y);
            sums[0] += qRed(at);
            sums[1] += qGreen(at);
            sums[2] += qBlue(at);
            low = std::min(low, qGray(at));
            high = std::max(high, qGray(at));
        }
    }
    const long count = static_cast<long>(picture.width()) * picture.height();
    return {QColor(static_cast<int>(sums[0] / count), static_cast<int>(sums[1] / count), static_cast<int>(sums[2] / count)), high - low};
}

} // namespace

class TestSwatchPainter : public QObject {
    Q_OBJECT

public:
    static void initMain() { requestOpenGL(); }

private Q_SLOTS:
    void init()
    {
        folder_ = std::make_unique<QTemporaryDir>();
        if (!surface_) { surface_ = swatchSurface(); }
        QVERIFY(surface_);
    }

    void aPictureIsDrawnOnceAndThenFound()
    {
        SwatchPainter painter = painterFor(surface_.get());
        const QImage picture = painter.picture(design());
        QCOMPARE(picture.size(), QSize(pixels, pixels));
        QVERIFY2(spreadOf(picture).range > 40, qPrintable(QString::number(spreadOf(picture).range)));
        QCOMPARE(painter.drawn(), 1);
        SwatchPainter later = painterFor(surface_.get());
        QCOMPARE(later.picture(design()), picture);
        QCOMPARE(later.drawn(), 0);
    }

    void itIsDrawnAnewWhenColourOrWeaveDiffer()
    {
        SwatchPainter painter = painterFor(surface_.get());
        const QImage before = painter.picture(design());
        Design other = *design();
        other.fabrics[0].warp.color = Color{200, 20, 20};
        other.fabrics[0].weft.color = Color{200, 20, 20};
        const QImage red = painter.picture(std::make_shared<const Design>(other));
        QCOMPARE(painter.drawn(), 2);
        QVERIFY(spreadOf(red).mean.red() > 2 * spreadOf(red).mean.blue());
        other = *design();
        other.fabrics[0].weave = weave_from_pattern("satin 8/3");
        QVERIFY(painter.picture(std::make_shared<const Design>(other)) != before);
        QCOMPARE(painter.drawn(), 3);
        QCOMPARE(painter.picture(design()), before);
        QCOMPARE(painter.drawn(), 3);
    }

    void itIsDrawnAnewByAnotherVersionOrWhenTheFileIsNotWhatItWas()
    {
        SwatchPainter painter = painterFor(surface_.get());
        painter.picture(design());
        QCoreApplication::setApplicationVersion("another");
        painter.picture(design());
        QCoreApplication::setApplicationVersion({});
        QCOMPARE(painter.drawn(), 2);
        for (const QString& name : QDir(folder_->path()).entryList({"*.png"})) {
            QVERIFY(QImage(pixels, 1, QImage::Format_RGB32).save(folder_->filePath(name)));
        }
        QCOMPARE(painter.picture(design()).height(), pixels);
        QCOMPARE(painter.drawn(), 3);
    }

    /// Against Qt's own conversion from linear light to sRGB.
    void lightIsEncodedForDisplays()
    {
        QOpenGLContext context;
        QVERIFY(context.create() && context.makeCurrent(surface_.get()));
        {
            const QSize size(4, 4);
            DisplayEncoder encoder;
            QCOMPARE(encoder.initialize(), QString());
            const auto light = lightCopy(size);
            QOpenGLFramebufferObject shown(size);
            const QColorTransform toDisplay = QColorSpace(QColorSpace::SRgbLinear).transformationToColorSpace(QColorSpace::SRgb);
            for (const float value : {0.0F, 0.002F, 0.02F, 0.18F, 0.5F, 1.0F}) {
                light->bind();
                context.functions()->glClearColor(value, 0.5F * value, 0.0F, 1.0F);
                context.functions()->glClear(GL_COLOR_BUFFER_BIT);
                encoder.encode(*light, shown);
                const QColor given = shown.toImage().pixelColor(1, 1), wanted = toDisplay.map(QColor::fromRgbF(value, 0.5F * value, 0.0F));
                QVERIFY2(std::abs(given.red() - wanted.red()) <= 1 && std::abs(given.green() - wanted.green()) <= 1 && given.blue() == 0,
                         qPrintable(QString("%1: %2 for %3").arg(value).arg(given.name(), wanted.name())));
            }
            encoder.release();
        }
        context.doneCurrent();
    }

    void anotherThreadMayDraw()
    {
        QImage picture;
        std::thread([&] { picture = painterFor(surface_.get()).picture(design()); }).join();
        QVERIFY(spreadOf(picture).range > 40);
    }

    void withoutOpenGLTheFlatClothStandsInAndIsNotKept()
    {
        SwatchPainter painter = painterFor(nullptr);
        QCOMPARE(painter.picture(design()).size(), QSize(pixels, pixels));
        painter.picture(design());
        QCOMPARE(painter.drawn(), 2);
        QVERIFY(QDir(folder_->path()).isEmpty());
    }

    void theFolderStaysSmall()
    {
        for (int i = 0; i < 20; ++i) {
            QFile old(folder_->filePath(QString("old%1.png").arg(i)));
            QVERIFY(old.open(QIODevice::ReadWrite));
            old.resize(1 << 20);
            old.setFileTime(QDateTime::currentDateTime().addDays(-1 - i), QFileDevice::FileModificationTime);
        }
        SwatchPainter painter = painterFor(surface_.get());
        painter.picture(design());
        qint64 bytes = 0;
        for (const QFileInfo& file : QDir(folder_->path()).entryInfoList(QDir::Files)) { bytes += file.size(); }
        QVERIFY(bytes <= most_swatch_bytes && bytes > most_swatch_bytes / 2);
        QVERIFY(QFile::exists(folder_->filePath("old0.png")));
        QVERIFY(!QFile::exists(folder_->filePath("old19.png")));
        painter.picture(design());
        QCOMPARE(painter.drawn(), 1);
    }

    void everyShippedPresetCanBeDrawn()
    {
        SwatchPainter painter = painterFor(surface_.get());
        for (const Preset& preset : shipped_presets()) {
            const QImage picture = painter.picture(std::make_shared<const Design>(preset.design));
            QVERIFY2(spreadOf(picture).range > 15, preset.fabric().name.c_str());
        }
    }

private:
    SwatchPainter painterFor(QOffscreenSurface* surface) const { return {surface, folder_->path(), pixels, pictureColors(QPalette())}; }
    static std::shared_ptr<const Design> design() { return std::make_shared<const Design>(shipped_presets().front().design); }

    std::unique_ptr<QTemporaryDir> folder_;
    std::unique_ptr<QOffscreenSurface> surface_;
};

QTEST_MAIN(TestSwatchPainter)
#include "tst_swatch_painter.moc"
