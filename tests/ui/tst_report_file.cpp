// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// Reports as PDF: they come out whole, in pages, or not at all.
#include "core/analysis/line_chart.h"
#include "core/analysis/page.h"
#include "core/base/error.h"
#include "ui/results/report_file.h"

#include <QFile>
#include <QTemporaryDir>
#include <QTest>

using namespace hygroloom;

namespace {

ReportPage paragraphs(int count)
{
    return {"Cotton, one drop",
            PageBlocks(static_cast<std::size_t>(count), PageText{"Water moves along the yarns until the pores are full."})};
}

QByteArray contents(const QString& file)
{
    QFile read(file);
    return read.open(QIODevice::ReadOnly) ? read.readAll() : QByteArray();
}

qsizetype pages(const QByteArray& pdf) { return pdf.count("/Type /Page\n") + pdf.count("/Type /Page "); }

} // namespace

class TestReportFile : public QObject {
    Q_OBJECT
    QTemporaryDir folder_;

    QByteArray written(const ReportPage& page)
    {
        const QString file = folder_.filePath("report.pdf");
        writeReport(page, file);
        return contents(file);
    }

private Q_SLOTS:
    void aShortReportIsOnePage()
    {
        const QByteArray pdf = written(paragraphs(3));
        QVERIFY(pdf.startsWith("%PDF-") && pdf.trimmed().endsWith("%%EOF"));
        QCOMPARE(pages(pdf), 1);
    }
    void aLongOneGoesOn() { QVERIFY(pages(written(paragraphs(200))) > 3); }
    void chartsAndMapsAreInIt()
    {
        const LineChart chart{"Radius", "time, s", "mm", {0, 1, 2}, {{"cotton", {0, 2, 3}}}};
        const ReportPicture map{"top", {64, 64, std::vector<std::uint8_t>(3 * 64 * 64, 128)}};
        const QByteArray plain = written(paragraphs(1)), with_chart = written({"Cotton", {PageDrawing{svg_of(chart)}}});
        const QByteArray with_maps = written({"Cotton", blocks_of({map, map, map})});
        QVERIFY(!with_chart.contains("/Subtype /Image")); // lines stay lines
        QVERIFY(with_chart.size() > plain.size() + 500);
        QVERIFY(with_maps.contains("/Subtype /Image"));
    }
    void aWebPageIsWrittenAsItIs()
    {
        const QString file = folder_.filePath("report.html");
        writeReport(paragraphs(1), file);
        QCOMPARE(contents(file).toStdString(), html_of(paragraphs(1)));
    }
    void picturesAtTrueScaleAreInIt()
    {
        ReportPicture map{"top", {64, 64, std::vector<std::uint8_t>(3 * 64 * 64, 128)}};
        const QByteArray plain = written({"Cotton", blocks_of({map})});
        map.width_mm = 40;
        const QByteArray scaled = written({"Cotton", blocks_of({map})});
        QCOMPARE(scaled.count("/Subtype /Image"), plain.count("/Subtype /Image")); // the bar is drawn
        QVERIFY(scaled.size() > plain.size());
    }
    void anUnknownEndingIsRefused()
    {
        for (const char* name : {"Poplin v1.2", "report.htm", "report"}) {
            const QString file = folder_.filePath(name);
            try {
                writeReport(paragraphs(1), file);
                QFAIL("It was written.");
            } catch (const Error& error) {
                const QString said = QString::fromStdString(error.what());
                QVERIFY2(said.startsWith(file + ": "), error.what());
                for (const char* ending : {".pdf", ".html", ".txt", ".json"}) QVERIFY2(said.contains(ending), error.what());
            }
            QVERIFY(!QFile::exists(file));
        }
    }
    void aNameWithoutAKnownEndingGetsOne()
    {
        const FileKind pdf{"PDF", "pdf"}, html{"Web page", "html"};
        QCOMPARE(withKnownEnding("Poplin v1.2", "pdf", pdf, html), QString("Poplin v1.2.pdf"));
        QCOMPARE(withKnownEnding("Poplin", "html", pdf, html), QString("Poplin.html"));
        for (const char* name : {"Poplin v1.2.pdf", "Poplin.HTML"}) QCOMPARE(withKnownEnding(name, "pdf", pdf, html), QString(name));
    }
    void whatCannotBeWrittenIsNamed()
    {
        try {
            writeReport(paragraphs(0), "/nowhere/report.pdf");
            QFAIL("It was written.");
        } catch (const FileError& error) {
            QVERIFY(std::string(error.what()).starts_with("/nowhere/report.pdf: "));
        }
    }
};

QTEST_MAIN(TestReportFile)
#include "tst_report_file.moc"
