// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// What a solver has come to, kept where its arrays are, so that it can go another way and come back.
#pragma once

#include "core/base/portable.h"

#include <algorithm>
#include <cstddef>
#include <cstring>
#include <memory>
#include <vector>

namespace hygroloom::inline HL_PRECISION {

template <typename T> struct CopyValues {
    const T* from;
    T* to;
    HL_FN void operator()(int i) const { to[i] = from[i]; }
};
template <typename T> CopyValues(const T*, T*) -> CopyValues<T>; // which clang 14 does not find by itself

/// Room for one state. keeper() and returner() are archives, see StateWriter and StateReader, which pass the same things in the same order.
template <typename Executor> class KeptState {
public:
    explicit KeptState(Executor& executor) : exec_(executor) {}

    class Keeper {
    public:
        static constexpr bool reads = false, stays = true; ///< on this machine, with all that the next step would find anew
        explicit Keeper(KeptState& kept) : kept_(kept) { kept_.begin(); }
        template <typename T> void value(const T& value) { values(&value, 1); }
        template <typename T> void values(const std::vector<T>& values, const char*) { this->values(values.data(), values.size()); }
        template <typename Buffer> void buffer(const Buffer& buffer, const char* name) { first(buffer, buffer.size(), name); }
        template <typename Buffer> void first(const Buffer& buffer, std::size_t count, const char*)
        {
            count = std::min(count, buffer.size()); // frames may not show it
            auto& own = kept_.template next<Buffer>();
            if (own.size() < count) own.resize(count);
            kept_.copy(buffer, own, count);
        }

    private:
        template <typename T> void values(const T* from, std::size_t count)
        {
            const auto* bytes = reinterpret_cast<const std::byte*>(from);
            kept_.values_.insert(kept_.values_.end(), bytes, bytes + count * sizeof(T));
        }
        KeptState& kept_;
    };

    class Returner {
    public:
        static constexpr bool reads = true, stays = true;
        explicit Returner(KeptState& kept) : kept_(kept) { kept_.at_ = kept_.array_ = 0; }
        template <typename T> void value(T& value) { values(&value, 1); }
        template <typename T> void values(std::vector<T>& values, const char*) { this->values(values.data(), values.size()); }
        template <typename Buffer> void buffer(Buffer& buffer, const char* name) { first(buffer, buffer.size(), name); }
        template <typename Buffer> void first(Buffer& buffer, std::size_t count, const char*)
        {
            kept_.copy(kept_.template next<Buffer>(), buffer, std::min(count, buffer.size()));
        }

    private:
        template <typename T> void values(T* to, std::size_t count)
        {
            if (count > 0) std::memcpy(to, kept_.values_.data() + kept_.at_, count * sizeof(T));
            kept_.at_ += count * sizeof(T);
        }
        KeptState& kept_;
    };

private:
    struct Array {
        virtual ~Array() = default;
    };
    template <typename Buffer> struct ArrayOf : Array {
        Buffer values;
    };

    void begin()
    {
        values_.clear();
        at_ = array_ = 0;
    }
    /// The next array's room: made anew where another one was kept there.
    template <typename Buffer> Buffer& next()
    {
        if (array_ == arrays_.size()) arrays_.emplace_back();
        std::unique_ptr<Array>& array = arrays_[array_++];
        if (dynamic_cast<ArrayOf<Buffer>*>(array.get()) == nullptr) array = std::make_unique<ArrayOf<Buffer>>();
        return static_cast<ArrayOf<Buffer>&>(*array).values;
    }
    template <typename Buffer> void copy(const Buffer& from, Buffer& to, std::size_t count)
    {
        exec_.for_each("keep", static_cast<int>(count), CopyValues{from.data(), to.data()});
    }

    Executor& exec_;
    std::vector<std::byte> values_;
    std::size_t at_ = 0, array_ = 0; ///< the next ones
    std::vector<std::unique_ptr<Array>> arrays_;
};

} // namespace hygroloom::inline HL_PRECISION
