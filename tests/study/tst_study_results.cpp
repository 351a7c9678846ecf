// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// The table of a study: what is written is read, in either form, soon, and without trust.
#include "core/base/error.h"
#include "core/base/random.h"
#include "core/study/csv_rows.h"
#include "core/study/results.h"

#include <QElapsedTimer>
#include <QFile>
#include <QTemporaryDir>
#include <QTest>

#include <csignal>
#include <sqlite3.h>
#include <sys/resource.h>

using namespace hygroloom;
using Role = StudyColumnRole;

namespace tst_study_results {
namespace {

StudyColumn numbers(const char* name, Role role, std::vector<double> values) { return {name, role, true, std::move(values), {}, {}}; }

StudyColumn words(const char* name, Role role, const std::vector<std::string>& values)
{
    StudyColumn column{name, role, false, {}, {}, {}};
    WordList list;
    for (const std::string& value : values) column.word_of.push_back(list.place_of(value));
    column.words = list.words();
    return column;
}

/// The sentence; empty: it is read.
QString refusal_of(const std::string& study)
{
    try {
        read_results_database(study);
    } catch (const FileError& error) {
        return error.what();
    }
    return {};
}

StudyTable table_of(std::size_t rows)
{
    const auto each = [rows](auto value) {
        std::vector<decltype(value(std::size_t{0}))> all;
        for (std::size_t i = 0; i < rows; ++i) all.push_back(value(i));
        return all;
    };
    const double none = std::numeric_limits<double>::quiet_NaN();
    StudyTable table;
    table.columns = {
        numbers("point", Role::point, each([](std::size_t i) { return static_cast<double>(i / 2); })),
        numbers("replicate", Role::replicate, each([](std::size_t i) { return static_cast<double>(i % 2); })),
        words("fabric", Role::fabric, each([](std::size_t i) { return std::string(i % 3 ? "Twill, \"2/1\"" : "Plain"); })),
        numbers("fabrics[0].ends_per_cm", Role::factor, each([](std::size_t i) { return 20 + 1.0 / (i + 3); })),
        words("fabrics[0].warp.material", Role::factor, each([](std::size_t i) { return std::string(i % 2 ? "cotton" : "flax"); })),
        words("status", Role::status, each([](std::size_t i) { return std::string(i == 4 ? row_failed : row_done); })),
        numbers("absorbency_time_s", Role::metric, each([none](std::size_t i) { return i == 4 ? none : 1e-3 * static_cast<double>(i); })),
        numbers("wall_s", Role::wall, each([](std::size_t) { return 0.25; })),
        words("device", Role::device, each([](std::size_t) { return std::string("A processor"); })),
        words("commit", Role::commit, each([](std::size_t) { return std::string("abc"); })),
        words("reason", Role::reason, each([](std::size_t i) { return std::string(i == 4 ? "Too wet, it says" : ""); }))};
    return table;
}

QString refusal(const std::string& text)
{
    try {
        parse_results(text, "results.csv");
        return "accepted";
    } catch (const FileError& error) {
        return error.what();
    }
}

} // namespace

class TestStudyResults : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void bothFormsGiveTheSameTable()
    {
        const QTemporaryDir folder;
        const std::filesystem::path file = folder.filePath("study.sqlite").toStdString();
        const StudyTable table = table_of(9);
        const std::string text = format_results(table);
        const StudyTable read = parse_results(text, "results.csv");
        QCOMPARE(read.columns.size(), table.columns.size());
        for (std::size_t k = 0; k < table.columns.size(); ++k) QVERIFY(read.columns[k].role == table.columns[k].role);
        QCOMPARE(format_results(read), text);
        QVERIFY(std::isnan(read.find("absorbency_time_s")->numbers[4]));
        QCOMPARE(read.find("reason")->word(4), std::string("Too wet, it says"));
        write_results_database(table, "the project", "the study", file);
        QCOMPARE(format_results(read_results_database(file)), text);
    }

    void theSameTableHasTheSameBytes()
    {
        const QTemporaryDir folder;
        QByteArray bytes[2];
        for (int i = 0; i < 2; ++i) {
            const QString file = folder.filePath(QString("study%1.sqlite").arg(i));
            write_results_database(table_of(5000), "p", "s", file.toStdString());
            QFile read(file);
            QVERIFY(read.open(QIODevice::ReadOnly));
            bytes[i] = read.readAll();
            QTest::qSleep(i == 0 ? 1100 : 0);
        }
        QVERIFY(bytes[0] == bytes[1]);
    }

    void manyRowsAreReadSoon()
    {
        const std::string text = format_results(table_of(100000));
        QElapsedTimer timer;
        timer.start();
        QCOMPARE(parse_results(text, "results.csv").rows(), std::size_t{100000});
        const qint64 took = timer.elapsed();
        qInfo("100 000 rows of 11 columns, %.1f MB: %lld ms", static_cast<double>(text.size()) / 1e6, static_cast<long long>(took));
        QVERIFY2(took < 2000, qPrintable(QString::number(took)));
    }

    void whatIsNoTableIsRefused()
    {
        QVERIFY(refusal("").contains("The header is missing."));
        QVERIFY(refusal("a,b\n").contains("line 1: This is no table of a study"));
        QVERIFY(refusal("point,replicate,status,m,device\n").contains("wall_s is missing"));
        const std::string head = "point,replicate,x,status,m,wall_s,device,commit,reason\n";
        QVERIFY(refusal(head + "0,0,1,done,2,0,d,c\n").contains("line 2: There are 8 fields; the header has 9."));
        QVERIFY(refusal(head + "0,0,1,done,2,0,d,c,,\n").contains("line 2: There are more fields"));
        QVERIFY(refusal(head + "0,0,1,done,wet,0,d,c,\n").contains("line 2: m must be a number; given is \"wet\"."));
        QVERIFY(refusal(head + "0,0,1,do").contains("torn"));
        QCOMPARE(refusal(head + "0,0,1,done,2,0,d,c,\n"), QString("accepted"));
    }

    void aFactorOfWordsAndNumbersIsWords()
    {
        const std::string head = "point,replicate,x,status,wall_s,device,commit,reason\n";
        const StudyTable table = parse_results(head + "0,0,12,done,0,d,c,\n1,0,wide,done,0,d,c,\n", "t");
        QVERIFY(!table.find("x")->is_number);
        QCOMPARE(table.find("x")->word(0), std::string("12"));
        QCOMPARE(table.find("x")->word(1), std::string("wide"));
    }

    void aTornDatabaseIsRefused()
    {
        const QTemporaryDir folder;
        const QString name = folder.filePath("study.sqlite");
        write_results_database(table_of(5000), "p", "s", name.toStdString());
        QFile file(name);
        QVERIFY(file.resize(file.size() / 2));
        QVERIFY_EXCEPTION_THROWN(read_results_database(name.toStdString()), FileError);
    }

    void columnsOfOtherTypesAreRefused()
    {
        const QTemporaryDir place;
        const std::filesystem::path file = place.filePath("study.sqlite").toStdString();
        const auto accepted = [&](const StudyTable& table) {
            write_results_database(table, "{}", "{}", file);
            try {
                return read_results_database(file).rows() == 5;
            } catch (const FileError&) {
                return false;
            }
        };
        QVERIFY(accepted(table_of(5)));
        for (std::size_t k : {0, 1, 2, 5, 6, 7, 8, 9, 10}) { // all but the factors
            StudyTable table = table_of(5);
            StudyColumn& column = table.columns[k];
            column = column.is_number ? words(column.name.c_str(), column.role, std::vector<std::string>(5, "x"))
                                      : numbers(column.name.c_str(), column.role, std::vector<double>(5, 1.0));
            QVERIFY(!accepted(table));
        }
        for (std::size_t k : {0, 1, 5}) {
            StudyTable table = table_of(5);
            table.columns.erase(table.columns.begin() + static_cast<std::ptrdiff_t>(k));
            QVERIFY(!accepted(table));
        }
    }

    void aHurtDatabaseIsReadOrRefused()
    {
        const QTemporaryDir place;
        const QString name = place.filePath("study.sqlite");
        write_results_database(table_of(20), "{}", "{}", name.toStdString());
        QFile file(name);
        QVERIFY(file.open(QIODevice::ReadOnly));
        const QByteArray whole = file.readAll();
        int refused = 0;
        for (std::uint64_t trial = 0; trial < 1500; ++trial) {
            QByteArray bytes = whole;
            for (std::uint64_t k = 0; k < 1 + trial % 4; ++k)
                bytes[static_cast<int>(random_bits(trial, 1, k) % static_cast<std::uint64_t>(bytes.size()))] =
                    static_cast<char>(random_bits(trial, 2, k));
            QFile hurt(place.filePath("hurt.sqlite"));
            QVERIFY(hurt.open(QIODevice::WriteOnly));
            hurt.write(bytes);
            hurt.close();
            try {
                read_results_database(hurt.fileName().toStdString());
            } catch (const FileError&) {
                ++refused;
            }
        }
        QVERIFY2(refused > 50, qPrintable(QString::number(refused)));
    }

    void whatIsNotAsExpectedIsNamed_data()
    {
        QTest::addColumn<QString>("sql");
        QTest::addColumn<QString>("sentence");
        const auto row = [](const char* name, const char* sql, const char* sentence) {
            QTest::newRow(name) << QString(sql) << QString(sentence);
        };
        row("a word for a number", "UPDATE rows SET point='x' WHERE number=3", "rows/point: This must be numbers.");
        row("bytes for a number", "UPDATE rows SET point=x'00' WHERE number=3", "rows/point: This must be numbers.");
        row("bytes for a word", "UPDATE rows SET status=x'00' WHERE number=3", "rows/status: This must be words.");
        row("no row", "DELETE FROM rows WHERE number=3", "rows: The rows are not counted one by one; the file is damaged.");
        row("rows without end", "ALTER TABLE rows RENAME TO r; CREATE VIEW rows AS SELECT * FROM r",
            "it holds \"r\", which recordings do not; it is damaged or no recording.");
        row("no table", "DROP TABLE rows", "its table \"rows\" is missing; it is damaged or no recording.");
        row("one more column", "ALTER TABLE rows ADD COLUMN more REAL", "its table \"rows\" has another form than recordings have.");
        row("no columns", "DELETE FROM meta WHERE name='columns'", "\"columns\" is missing; the recording is damaged or no recording.");
        row("a recording", "UPDATE meta SET value='hygroloom-recording' WHERE name='format'", "This is no table of a study.");
        row("a role that there is not", "UPDATE meta SET value='[[\"point\",99]]' WHERE name='columns'",
            "columns: This is no table of a study.");
    }
    void whatIsNotAsExpectedIsNamed()
    {
        QFETCH(QString, sql);
        QFETCH(QString, sentence);
        const QTemporaryDir place;
        const std::string file = place.filePath("study.sqlite").toStdString();
        write_results_database(table_of(20), "{}", "{}", file);
        sqlite3* opened = nullptr;
        QCOMPARE(sqlite3_open(file.c_str(), &opened), SQLITE_OK);
        QCOMPARE(sqlite3_exec(opened, qPrintable(sql), nullptr, nullptr, nullptr), SQLITE_OK);
        sqlite3_close(opened);
        QCOMPARE(refusal_of(file), QString::fromStdString(file) + ": " + sentence);
    }

    void columnsWhoseNamesDifferInTheirLettersAlone()
    {
        const QTemporaryDir place;
        const std::string file = place.filePath("study.sqlite").toStdString();
        StudyTable table = table_of(3);
        table.columns[3].name = "Number";
        table.columns[4].name = "STATUS \"x\"";
        table.columns[6].name = "Status";
        write_results_database(table, "{}", "{}", file);
        const StudyTable read = read_results_database(file);
        for (std::size_t k = 0; k < table.columns.size(); ++k) QCOMPARE(read.columns[k].name, table.columns[k].name);
        QCOMPARE(format_results(read), format_results(table));
    }

    /// A limit on the size of files stands for a disk that is full.
    void aFullDiskIsAnError()
    {
        const QTemporaryDir place;
        const std::filesystem::path file = place.filePath("study.sqlite").toStdString();
        rlimit before{};
        getrlimit(RLIMIT_FSIZE, &before);
        std::signal(SIGXFSZ, SIG_IGN);
        const rlimit tight{2000, before.rlim_max};
        setrlimit(RLIMIT_FSIZE, &tight);
        QString said;
        try {
            write_results_database(table_of(500), "{}", "{}", file);
        } catch (const FileError& error) {
            said = error.what();
        }
        setrlimit(RLIMIT_FSIZE, &before);
        QVERIFY2(said.contains("study.sqlite: The file cannot be written"), qPrintable(said));
        QVERIFY(!std::filesystem::exists(file));
        write_results_database(table_of(500), "{}", "{}", file);
        QCOMPARE(read_results_database(file).rows(), std::size_t{500});
    }
};

} // namespace tst_study_results

QTEST_APPLESS_MAIN(tst_study_results::TestStudyResults)
#include "tst_study_results.moc"
