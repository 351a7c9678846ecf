// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// The operators new and delete of every program with the core in it, about the size from which they hand out huge pages. Sanitizers bring
// operators of their own, which end the program where a size is impossible: what they do in another way is not tested under them.
#include <QTest>

#include <cstdint>
#include <limits>
#include <new>
#include <numeric>
#include <string>
#include <vector>

#if defined(__has_feature)
#if __has_feature(address_sanitizer) || __has_feature(thread_sanitizer) || __has_feature(memory_sanitizer)
#define OPERATORS_OF_A_SANITIZER
#endif
#endif
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
#define OPERATORS_OF_A_SANITIZER
#endif

namespace {

constexpr std::size_t mebibyte = std::size_t{1} << 20, large = 4 * mebibyte; // bytes

#ifdef OPERATORS_OF_A_SANITIZER
constexpr bool own_operators = false;
#else
constexpr bool own_operators = true;
#endif

bool is_aligned(const void* block) { return reinterpret_cast<std::uintptr_t>(block) % (2 * mebibyte) == 0; }

/// Writes at both ends and reads it again. Volatile: else the compiler may leave out block and all.
bool holds(void* block, std::size_t size)
{
    auto* bytes = static_cast<volatile unsigned char*>(block);
    bytes[0] = 17;
    bytes[size - 1] = 42;
    return bytes[0] == 17 && bytes[size - 1] == 42;
}

} // namespace

class TestLargeBlocks : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void blocksHoldTheirBytes_data()
    {
        QTest::addColumn<qulonglong>("size");
        QTest::addColumn<bool>("huge");
        QTest::newRow("two bytes") << qulonglong{2} << false;
        QTest::newRow("4 MiB - 1") << qulonglong{large - 1} << false;
        QTest::newRow("4 MiB") << qulonglong{large} << true;
        QTest::newRow("4 MiB + 1") << qulonglong{large + 1} << true;
    }
    void blocksHoldTheirBytes()
    {
        QFETCH(qulonglong, size);
        QFETCH(bool, huge);
        for (const bool sized : {false, true}) {
            void* block = ::operator new(size);
            QVERIFY(holds(block, size));
            if (huge && own_operators) QVERIFY(is_aligned(block));
            if (sized)
                ::operator delete(block, size);
            else
                ::operator delete(block);
        }
        void* array = ::operator new[](size);
        QVERIFY(holds(array, size));
        if (huge && own_operators) QVERIFY(is_aligned(array));
        ::operator delete[](array);
        void* without_throw = ::operator new(size, std::nothrow);
        QVERIFY(without_throw != nullptr && holds(without_throw, size));
        if (huge && own_operators) QVERIFY(is_aligned(without_throw));
        ::operator delete(without_throw, std::nothrow);
        auto* bytes = new (std::nothrow) unsigned char[size];
        QVERIFY(bytes != nullptr && holds(bytes, size));
        delete[] bytes;
    }
    void blocksOfNoBytesDiffer()
    {
        void *one = ::operator new(0), *other = ::operator new(0);
        QVERIFY(one != nullptr && other != nullptr && one != other);
        ::operator delete(one);
        ::operator delete(other);
        ::operator delete(nullptr);
    }
    void arraysOfObjectsAreMadeAndUnmade()
    {
        constexpr std::size_t count = 2 * large / sizeof(std::string); // the array's length stands before its elements
        auto* words = new std::string[count];
        words[0] = "the first of them, too long to lie in the string itself";
        words[count - 1] = words[0];
        QCOMPARE(words[count - 1], words[0]);
        QVERIFY(words[1].empty() && words[count - 2].empty());
        delete[] words;
    }
    void vectorsKeepWhatTheyHoldAsTheyGrow()
    {
        constexpr std::size_t count = 64 * mebibyte / sizeof(std::uint64_t);
        std::vector<std::uint64_t> numbers;
        for (std::uint64_t i = 0; i < count; ++i) numbers.push_back(i); // through sizes on both sides of a large block
        QCOMPARE(numbers.front(), std::uint64_t{0});
        QCOMPARE(numbers.back(), std::uint64_t{count - 1});
        QCOMPARE(std::accumulate(numbers.begin(), numbers.end(), std::uint64_t{0}), std::uint64_t{count / 2 * (count - 1)});
        if (own_operators) QVERIFY(is_aligned(numbers.data()));
        numbers.resize(1000);
        numbers.shrink_to_fit();
        QCOMPARE(numbers.back(), std::uint64_t{999});
    }
    void impossibleSizesAreRefused_data()
    {
        QTest::addColumn<qulonglong>("size");
        QTest::newRow("more than rounds up") << qulonglong{std::numeric_limits<std::size_t>::max()};
        QTest::newRow("more than there are addresses") << qulonglong{std::numeric_limits<std::size_t>::max() / 4};
    }
    void impossibleSizesAreRefused()
    {
        if (!own_operators) QSKIP("a sanitizer's operators end the program here");
        QFETCH(qulonglong, size);
        bool thrown = false;
        try {
            ::operator delete(::operator new(size));
        } catch (const std::bad_alloc&) {
            thrown = true;
        }
        QVERIFY(thrown);
        QVERIFY(::operator new(size, std::nothrow) == nullptr);
        QVERIFY(::operator new[](size, std::nothrow) == nullptr);
    }
};

QTEST_APPLESS_MAIN(TestLargeBlocks)
#include "tst_large_blocks.moc"
