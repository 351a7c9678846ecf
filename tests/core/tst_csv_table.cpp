// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// Tables as spreadsheets write them.
#include "core/base/csv_table.h"
#include "core/base/error.h"

#include <QTest>

using namespace hygroloom;

namespace tst_csv_table {
namespace {

CsvTable read(const std::string& text) { return read_csv(text, "m.csv", {"time_s", "height_mm"}, {"spread"}); }

std::string refusal(const std::string& text)
{
    try {
        const CsvTable table = read(text);
        for (std::size_t row = 0; row < table.rows.size(); ++row) number_in(table, row, 1, "height_mm");
    } catch (const Error& error) {
        return error.what();
    }
    return "accepted";
}

} // namespace

class TestCsvTable : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void spreadsheetsTablesAreReadAlike_data()
    {
        QTest::addColumn<QByteArray>("text");
        QTest::newRow("commas") << QByteArray("time_s,height_mm\n1,8.9\n2,12.8\n");
        QTest::newRow("CRLF") << QByteArray("time_s,height_mm\r\n1,8.9\r\n2,12.8\r\n");
        QTest::newRow("CR") << QByteArray("time_s,height_mm\r1,8.9\r2,12.8\r");
        QTest::newRow("no end") << QByteArray("time_s,height_mm\n1,8.9\n2,12.8");
        QTest::newRow("semicolons") << QByteArray("time_s;height_mm\n1;8.9\n2;12.8\n");
        QTest::newRow("decimal commas") << QByteArray("time_s;height_mm\n1,0;8,9\n2;\"12,8\"\n");
        QTest::newRow("sep") << QByteArray("sep=;\ntime_s;height_mm\n1;8,9\n2;12,8\n");
        QTest::newRow("sep of a comma") << QByteArray("SEP=,\r\ntime_s,height_mm\r\n1,8.9\r\n2,12.8\r\n");
        QTest::newRow("byte order mark, sep") << QByteArray(
            "\xef\xbb\xbf\nsep=;\r\n# measured\r\n\r\ntime_s;height_mm\r\n1;8,9\r\n2;12,8\r\n");
    }
    void spreadsheetsTablesAreReadAlike()
    {
        QFETCH(QByteArray, text);
        const CsvTable table = read(text.toStdString());
        QCOMPARE(table.rows.size(), std::size_t(2));
        QCOMPARE(number_in(table, 0, 0, "time_s"), 1.0);
        QCOMPARE(number_in(table, 0, 1, "height_mm"), 8.9);
        QCOMPARE(number_in(table, 1, 1, "height_mm"), 12.8);
    }
    void linesAreCountedHoweverTheyEnd()
    {
        for (const char* end : {"\n", "\r", "\r\n"}) {
            std::string text;
            for (const char* line : {"time_s,height_mm", "1,2", "", "3,x"}) text += std::string(line) + end;
            QCOMPARE(refusal(text), std::string("m.csv: line 4: height_mm must be a number with a dot for its decimals; given is \"x\"."));
        }
    }
    void whatIsNoSuchTableIsNamed_data()
    {
        QTest::addColumn<QByteArray>("text");
        QTest::addColumn<QString>("says");
        QTest::newRow("tabs") << QByteArray("time_s\theight_mm\n1\t8.9\n") << "m.csv: line 1: The columns are separated by tabs";
        QTest::newRow("sep of a tab") << QByteArray("sep=\t\ntime_s\theight_mm\n1\t8.9\n")
                                      << "m.csv: line 1: The columns are separated by tabs";
        QTest::newRow("UTF-16") << QByteArray("\xff\xfet\0i\0", 6) << "m.csv: The text is UTF-16; save the table as CSV in UTF-8.";
        QTest::newRow("UTF-16, big") << QByteArray("\xfe\xff\0t\0i", 6) << "The text is UTF-16";
        QTest::newRow("zeros") << QByteArray("time_s,height_mm\n1,\0\n", 21) << "This is no text";
        QTest::newRow("two commas") << QByteArray("time_s;height_mm\n1;1,000,5\n")
                                    << "with a dot for its decimals, or a comma; given is \"1,000,5\"";
        QTest::newRow("dots and a comma") << QByteArray("time_s;height_mm\n1;1.000,5\n") << "given is \"1.000,5\"";
        QTest::newRow("comma among commas") << QByteArray("time_s,height_mm\n1,\"8,9\"\n")
                                            << "with a dot for its decimals; given is \"8,9\"";
        QTest::newRow("nothing") << QByteArray("\n\n") << "The table is empty";
    }
    void whatIsNoSuchTableIsNamed()
    {
        QFETCH(QByteArray, text);
        QFETCH(QString, says);
        const QString message = QString::fromStdString(refusal(text.toStdString()));
        QVERIFY2(message.contains(says), qPrintable(message));
    }
    void longFieldsAreNotPrintedWhole()
    {
        const std::string long_text(10'000'000, 'x');
        for (const std::string& text : {"time_s," + long_text + "\n1,2\n", "time_s,height_mm\n1," + long_text + "\n"}) {
            const std::string message = refusal(text);
            QVERIFY2(message.size() < 200 && message.find("one has 10000000 and begins with \"xxxx") != std::string::npos,
                     message.substr(0, 300).c_str());
        }
        std::string many = "time_s";
        for (int i = 0; i < 50000; ++i) many += ",c" + std::to_string(i);
        const std::string message = refusal(many + "\n");
        QVERIFY2(message.size() < 500 && message.find("and 49981 more") != std::string::npos, message.substr(0, 600).c_str());
    }
};

} // namespace tst_csv_table

QTEST_APPLESS_MAIN(tst_csv_table::TestCsvTable)
#include "tst_csv_table.moc"
