// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// Garments whose bytes were changed, in every format that is read: each is refused with a sentence, or read; none ends the program, and
// none takes for ever. HYGROLOOM_MUTATIONS=2000 tries so many of each.
#include "core/base/shipped_file.h"
#include "core/garment/mesh_bytes.h"
#include "core/garment/mesh_limits.h"
#include "tests/garment/folded.h"
#include "tests/garment/foreign.h"

#include <QTemporaryDir>
#include <QTest>

#include <csignal>
#include <ctime>
#include <thread>
#include <unistd.h>

using namespace hygroloom;
namespace fs = std::filesystem;

namespace {

/// Changes bytes by a sequence of numbers that is always the same.
class Mutation {
public:
    explicit Mutation(unsigned seed) : state_(seed * 2654435761u + 1) {}
    std::string of(const std::string& good)
    {
        std::string bytes = good;
        for (unsigned i = 0; i < 1 + below(2) && !bytes.empty(); ++i) change(bytes);
        return bytes;
    }

private:
    unsigned next() { return (state_ = state_ * 1664525u + 1013904223u) >> 8; }
    std::size_t below(std::size_t most) { return next() % most; }
    void change(std::string& bytes)
    {
        const std::size_t at = below(bytes.size()), length = std::min<std::size_t>(1 + below(40), bytes.size() - at);
        switch (below(7)) {
        case 0: bytes[at] = static_cast<char>(next()); break;
        case 1: bytes[at] = "0123456789.-e/ \n\"{}[]<>,:"[below(25)]; break;
        case 2: bytes.erase(at, length); break;
        case 3: bytes.insert(below(bytes.size()), bytes.substr(at, length)); break;
        case 4: bytes.resize(at); break;
        case 5: change_number(bytes, at); break;
        default: { // numbers of two, four and eight bytes that lie at an end
            static const std::string ends[] = {std::string("\xff\xff\xff\xff\xff\xff\xff\xff"), std::string("\xff\xff\xff\x7f\0\0\0\0", 8),
                                               std::string(8, '\0'), std::string("\0\0\0\x80\0\0\0\0", 8), std::string("\0\0\x80\x7f", 4)};
            const std::string& end = ends[below(std::size(ends))];
            const std::size_t size = std::min({std::size_t(1) << below(4), end.size(), bytes.size() - at});
            bytes.replace(at, size, end, 0, size);
        }
        }
    }
    void change_number(std::string& bytes, std::size_t from)
    {
        static constexpr const char* numbers[] = {"-1",     "99999999",    "4294967296",          "1e308", "nan", "0",
                                                  "1e-320", "-2147483648", "18446744073709551615"};
        const std::size_t at = bytes.find_first_of("0123456789", from);
        if (at == std::string::npos) return;
        const std::size_t end = std::min(bytes.find_first_not_of("0123456789.e+-", at), bytes.size());
        bytes.replace(at, end - at, numbers[below(std::size(numbers))]);
    }
    unsigned state_;
};

/// Whether a process that this one started is still there, or was left as a zombie.
bool has_child()
{
    const std::string children = bytes_of(fmt::format("/proc/self/task/{}/children", ::gettid()));
    return !children.empty();
}

} // namespace

class TestGarmentMutated : public QObject {
    Q_OBJECT
    QTemporaryDir folder_;
    fs::path at(const std::string& name) const { return fs::path(folder_.path().toStdString()) / name; }
    std::string refusal(const std::string& bytes, const std::string& name)
    {
        write_bytes(at(name), bytes);
        return refusal_of([&] { read_pattern(from_file(at(name).string()), {}); });
    }

private Q_SLOTS:
    void changedFilesAreReadOrRefused_data()
    {
        QTest::addColumn<QString>("name");
        QTest::addColumn<QByteArray>("good");
        const auto row = [](const char* title, const char* name, const std::string& good) {
            QTest::newRow(title) << QString(name) << QByteArray(good.data(), static_cast<qsizetype>(good.size()));
        };
        const std::vector<Sheet> sheets = two_sheets(3, 3);
        std::string obj = obj_of(sheets);
        obj += "usemtl cloth\nf 1/1 2/2 6/6 \\\n 5/5\ng\nf -1/-1 -2/-2 -6/-6 -5/-5\n";
        row("pattern", "x.json", bytes_of(garments + "tee.json"));
        row("obj", "x.obj", obj);
        row("ply text", "x.ply", ply_of(sheets, PlyForm::text));
        row("ply little", "x.ply", ply_of(sheets, PlyForm::little));
        row("ply big", "x.ply", ply_of(sheets, PlyForm::big));
        row("glb", "x.glb", glb_of(sheets));
        GlbForm form;
        form.uv_type = 5123;
        form.nodes = {R"({"children":[1,2],"scale":[1,1,1],"rotation":[0,0,0,1]})", R"({"mesh":0,"skin":0,"name":"a"})", R"({"mesh":1})"};
        form.roots = 1;
        form.extra = R"(,"skins":[{"joints":[0,1]}],"materials":[{"name":"m"}],"extensionsRequired":["KHR_mesh_quantization"])";
        row("glb with nodes", "x.glb", glb_of(sheets, form));
        row("fbx", "x.fbx", fbx_of(sheets));
        row("collada", "x.dae", dae_of(sheets));
    }
    void changedFilesAreReadOrRefused()
    {
        QFETCH(QString, name);
        QFETCH(QByteArray, good);
        const bool apart = name.endsWith(".fbx") || name.endsWith(".dae");
        bool is_number = false;
        const int asked = qEnvironmentVariableIntValue("HYGROLOOM_MUTATIONS", &is_number);
        const unsigned tries = is_number ? static_cast<unsigned>(asked) : apart ? 60 : 200;
        const std::string original = good.toStdString(), file = name.toStdString();
        QCOMPARE(refusal(original, file), std::string());
        unsigned refused = 0, broke_off = 0, too_much = 0;
        double longest = 0; // s of a processor
        for (unsigned seed = 0; seed < tries; ++seed) {
            const std::clock_t start = std::clock();
            const std::string sentence = refusal(Mutation(seed).of(original), file);
            longest = std::max(longest, static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC);
            refused += !sentence.empty();
            broke_off += sentence.find("broke off") != std::string::npos;
            too_much += sentence.find("takes more than") != std::string::npos;
            if (!sentence.empty()) QVERIFY2(sentence.find(file) != std::string::npos && sentence.ends_with('.'), sentence.c_str());
        }
        qInfo("%u changed, %u refused (reader broke off: %u, took too much: %u), the rest read; the longest took %.2f s here", tries,
              refused, broke_off, too_much, longest);
        QVERIFY(refused > tries / 10);
        QVERIFY(longest < 5);
        QVERIFY(!has_child());
    }
    void foreignFormatsGiveTheirAreas()
    {
        for (const auto& [name, bytes] : {std::pair("x.fbx", fbx_of(two_sheets())), std::pair("x.dae", dae_of(two_sheets()))}) {
            write_bytes(at(name), bytes);
            const GarmentPattern pattern = read_pattern(from_file(at(name).string()), {});
            QCOMPARE(pattern.panels.size(), std::size_t(2));
            QCOMPARE(pattern.panels[1].name, std::string("right"));
            for (const PatternPanel& panel : pattern.panels) QVERIFY(std::abs(area_of(panel) / 0.2 - 1) < 1e-5);
        }
    }
    /// A file of some kB can ask a foreign library for more than a machine has.
    void aReaderThatTakesTooMuchIsEnded()
    {
        std::string bytes = dae_of(two_sheets());
        bytes.replace(bytes.find("count=\"243\""), 11, "count=\"4000000000\"");
        const std::string sentence = refusal(bytes, "x.dae");
        QVERIFY2(sentence.find("takes more than 30") != std::string::npos && sentence.find(" MB of memory") != std::string::npos,
                 sentence.c_str());
    }
    void readingCanBeCancelled()
    {
        write_bytes(at("x.dae"), dae_of(two_sheets(300, 300)));
        std::atomic<bool> cancel = true;
        QVERIFY_EXCEPTION_THROWN(read_pattern(from_file(at("x.dae").string()), {}, [&] { return cancel.load(); }), Cancelled);
        cancel = false;
        std::thread later([&cancel] {
            std::this_thread::sleep_for(std::chrono::milliseconds(30));
            cancel = true;
        });
        QVERIFY_EXCEPTION_THROWN(read_pattern(from_file(at("x.dae").string()), {}, [&] { return cancel.load(); }), Cancelled);
        later.join();
        QVERIFY(!has_child());
    }
    void noFileNextToAForeignOneIsOpened()
    {
        QVERIFY(!refusal("", "x.fbx").empty());
        fs::create_directories(at("folder.dae"));
        QVERIFY(refusal_of([&] { read_pattern(from_file(at("folder.dae").string()), {}); }).find("This is a folder") != std::string::npos);
        write_bytes(at("y.obj"), obj_of(two_sheets()));
        QVERIFY(!refusal("mtllib y.obj\n", "x.dae").empty());
        QVERIFY(!refusal(obj_of(two_sheets()), "x.fbx").empty()); // another format under that name is no FBX
    }
    void answersThatMakeNoSenseAreRefused()
    {
        FlatMesh mesh;
        mesh.places = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
        mesh.uv = {{0, 0}, {1, 0}, {0, 1}};
        mesh.triangles = mesh.uv_triangles = {{0, 1, 2}};
        mesh.label = {0};
        mesh.labels = {"front\x1b[31m"};
        mesh.issues = {"one"};
        mesh.metre = 1;
        const std::string good = answer_bytes(mesh);
        const FlatMesh again = mesh_from_answer(good, "x");
        QVERIFY(again.places.size() == 3 && again.triangles == mesh.triangles && again.uv == mesh.uv && again.metre == 1);
        QVERIFY(again.labels[0].find('\x1b') == std::string::npos);
        const auto refused = [](const std::string& bytes) { return refusal_of([&] { mesh_from_answer(bytes, "x"); }); };
        for (std::size_t size = 0; size < good.size(); ++size) QVERIFY(!refused(good.substr(0, size)).empty());
        QVERIFY(!refused(good + "x").empty());
        for (const int wrong : {-1, 3, 1 << 30}) {
            FlatMesh bad = mesh;
            bad.triangles[0][1] = wrong;
            QVERIFY(refused(answer_bytes(bad)).starts_with("x: What its reader"));
            bad = mesh;
            bad.uv_triangles[0][2] = wrong;
            QVERIFY(!refused(answer_bytes(bad)).empty());
            bad = mesh;
            bad.label[0] = wrong == -1 ? -2 : wrong;
            QVERIFY(!refused(answer_bytes(bad)).empty());
        }
        FlatMesh bad = mesh;
        bad.places[2].y = std::nan("");
        QVERIFY(!refused(answer_bytes(bad)).empty());
        QCOMPARE(refused(refusal_bytes("It is \n broken.")), refused(refusal_bytes("x: It is \n broken.")));
        for (unsigned seed = 0; seed < 2000; ++seed) refused(Mutation(seed).of(good));
    }
    void theReaderLimitsItself()
    {
        const fs::path program = shipped_file("hygroloom-mesh");
        QVERIFY(!program.empty());
        // The answer goes to a pipe; a file would be one that it writes.
        write_bytes(at("x.dae"), dae_of(two_sheets()));
        const std::string call = fmt::format("'{}' dae x < '{}' > '{}'", program.string(), at("x.dae").string(), at("answer").string());
        QVERIFY(std::system(call.c_str()) != 0 || fs::file_size(at("answer")) == 0);
        QCOMPARE(fs::file_size(at("answer")), std::uintmax_t(0));
    }
};

QTEST_APPLESS_MAIN(TestGarmentMutated)
#include "tst_garment_mutated.moc"
