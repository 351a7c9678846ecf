// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// Projects on a disk: what cannot be read is refused, and a save that fails leaves everything as it was.
#include "core/project/atomic_file.h"
#include "tests/core/rich_project.h"

#include <fmt/format.h>

#include <QTemporaryDir>
#include <QTest>

#include <csignal>
#include <sys/resource.h>
#include <sys/stat.h>
#include <unistd.h>

using namespace hygroloom;
namespace fs = std::filesystem;

namespace {

int files_in(const fs::path& folder) { return static_cast<int>(std::distance(fs::directory_iterator(folder), fs::directory_iterator())); }

} // namespace

class TestProjectSaving : public QObject {
    Q_OBJECT
    QTemporaryDir folder_;
    fs::path path(const char* name) const { return fs::path(folder_.path().toStdString()) / name; }

private Q_SLOTS:
    void filesThatCannotBeReadAreRefused()
    {
        QVERIFY(has(message_of([&] { read_project(path("none.hygro")); }), "cannot be opened"));
        QVERIFY(has(message_of([&] { read_project(path(".")); }), "folder"));
        QVERIFY(has(message_of([&] { read_project("/dev/null"); }), "not a regular file"));
        std::ofstream(path("empty.hygro")).close();
        QVERIFY(has(message_of([&] { read_project(path("empty.hygro")); }), "empty"));
        std::ofstream(path("large.hygro")).close();
        fs::resize_file(path("large.hygro"), largest_project_bytes + 1); // sparse: refused before it is read
        QVERIFY(has(message_of([&] { read_project(path("large.hygro")); }), "at most 64 MiB"));
        fs::remove(path("large.hygro"));
        if (geteuid() == 0) return; // root may read everything
        write_project(rich(), path("secret.hygro"));
        fs::permissions(path("secret.hygro"), fs::perms::none);
        QVERIFY(has(message_of([&] { read_project(path("secret.hygro")); }), "Permission denied"));
    }
    void savingKeepsThePreviousVersion()
    {
        const fs::path file = path("save.hygro");
        Design design = rich();
        write_project(design, file);
        QVERIFY(!fs::exists(file.string() + "~"));
        const std::string first = bytes_of(file);
        design.fabrics[0].ends_per_cm = 12.5;
        write_project(design, file);
        QVERIFY(read_project(file) == design);
        QCOMPARE(bytes_of(file.string() + "~"), first);
        write_project(design, file);
        QCOMPARE(bytes_of(file.string() + "~"), bytes_of(file));
    }
    void savingKeepsPermissionsAndLinks()
    {
        fs::create_directory(path("links"));
        const fs::path file = path("links/real.hygro"), link = path("links/link.hygro");
        write_project(rich(), file);
        fs::permissions(file, fs::perms::owner_read | fs::perms::owner_write);
        fs::create_symlink("real.hygro", link);
        write_project(rich(), link);
        QVERIFY(fs::is_symlink(link));
        QCOMPARE(int(fs::status(file).permissions()), 0600);
        const fs::path dangling = path("links/dangling.hygro"), later = path("links/later.hygro");
        fs::create_symlink("later.hygro", dangling);
        write_project(rich(), dangling);
        QVERIFY(fs::is_symlink(dangling) && fs::is_regular_file(later));
        QVERIFY(read_project(file) == rich());
    }
    /// In a container a program often has the number of the one before, which may have been killed while it wrote.
    void whatOneOfTheSameNumberLeftIsInNobodysWay()
    {
        const fs::path target = path("left.hygro");
        const auto left = [&](unsigned count) { return path(fmt::format(".left.{}-{}.hygro", ::getpid(), count).c_str()); };
        for (unsigned count = 0; count < 200; ++count) std::ofstream(left(count)) << "half a pro";
        write_file(target, "whole");
        QCOMPARE(read_file(target, 100), std::string("whole"));
        for (unsigned count = 0; count < 200; ++count) QCOMPARE(fs::file_size(left(count)), std::uintmax_t(10));
        for (unsigned count = 0; count < 200; ++count) fs::remove(left(count));
    }
    void aLoopOfLinksIsRefused()
    {
        fs::create_directory(path("loop"));
        fs::create_symlink("b.hygro", path("loop/a.hygro"));
        fs::create_symlink("a.hygro", path("loop/b.hygro"));
        QVERIFY(has(message_of([&] { write_project(rich(), path("loop/a.hygro")); }), "The link cannot be followed"));
        QVERIFY(fs::is_symlink(path("loop/a.hygro")) && fs::is_symlink(path("loop/b.hygro")));
        QCOMPARE(files_in(path("loop")), 2);
    }
    void aNameThatIsTooLongIsRefusedBeforeAnythingIsWritten()
    {
        bool began = false;
        const auto write = [&](const fs::path&) { began = true; };
        QVERIFY(has(message_of([&] { write_file_with(path(std::string(300, 'n').c_str()), write); }), "The file cannot be written"));
        QVERIFY(!began);
    }
    void failedSaveLeavesEverythingAsItWas()
    {
        fs::create_directory(path("full"));
        const fs::path file = path("full/cloth.hygro");
        write_project(rich(), file);
        const std::string before = bytes_of(file);
        Design larger = rich();
        larger.fabrics.resize(20, larger.fabrics[0]);

        // A disk that is full after 1 kB.
        rlimit old{};
        getrlimit(RLIMIT_FSIZE, &old);
        const rlimit tight{1024, old.rlim_max};
        const auto handler = std::signal(SIGXFSZ, SIG_IGN);
        setrlimit(RLIMIT_FSIZE, &tight);
        const std::string message = message_of([&] { write_project(larger, file); });
        setrlimit(RLIMIT_FSIZE, &old);
        std::signal(SIGXFSZ, handler);

        QVERIFY2(has(message, "cannot be written"), message.c_str());
        QCOMPARE(bytes_of(file), before);
        QCOMPARE(files_in(path("full")), 1); // no temporary file, no backup
    }
    void designsNoFileCanHoldAreNotWritten()
    {
        fs::create_directory(path("nan"));
        const fs::path file = path("nan/cloth.hygro");
        Design design = rich();
        design.fabrics[1].warp.twist_per_m = std::nan("");
        QVERIFY(has(message_of([&] { write_project(design, file); }), "fabrics[1].warp.twist_per_m"));
        design = rich();
        design.fabrics[1].name = "\xff";
        QVERIFY(has(message_of([&] { write_project(design, file); }), "UTF-8"));
        QCOMPARE(files_in(path("nan")), 0);
    }
    void savingIntoNowhereSaysSo()
    {
        QVERIFY(has(message_of([&] { write_project(rich(), path("nowhere/cloth.hygro")); }), "cannot be written"));
        QVERIFY(has(message_of([&] { write_project(rich(), path(".")); }), "folder"));
        QVERIFY(has(message_of([&] { write_project(rich(), "/dev/full"); }), "not a regular file"));
    }
};

QTEST_APPLESS_MAIN(TestProjectSaving)
#include "tst_project_saving.moc"
