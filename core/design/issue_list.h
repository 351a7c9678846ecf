// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// Collects issues while validate() walks through a design.
#pragma once

#include "core/base/words.h"
#include "core/design/fields.h"
#include "core/design/fitted_fabric.h"
#include "core/design/issue.h"

#include <fmt/format.h>

#include <cmath>
#include <cstdlib>
#include <set>

namespace hygroloom {

struct IssueList {
    std::vector<Issue> issues;

    void add(Severity severity, std::string code, Place where, Message message)
    {
        if (severity == Severity::error) ++errors_;
        issues.push_back({severity, std::move(code), std::move(where), std::move(message)});
    }
    void error(std::string code, Place where, Message message)
    {
        add(Severity::error, std::move(code), std::move(where), std::move(message));
    }

    /// least <= value <= most, or an issue; NaN and infinities never pass. Whether it passed.
    bool range(const Place& where, Argument what, double value, double least, double most, Stored unit = Stored::number)
    {
        if (std::isfinite(value) && value >= least && value <= most) return true;
        error("range", where,
              say("The {} must be from {}; given is {}.", std::move(what), Between{least, most, unit},
                  Bare{outside(value, least, most), unit}));
        return false;
    }
    /// The same of all numbers of an object, or of one.
    template <typename Owner> bool fields(const Place& where, const Owner& owner)
    {
        const int before = errors();
        for (const Field<Owner>& each : fields_of<Owner>()) field(where, each, owner);
        return errors() == before;
    }
    template <typename Owner> bool field(const Place& where, const Field<Owner>& field, const Owner& owner)
    {
        const std::optional<double> number = field_value(field, owner);
        return !field.is_number() || !number ||
               range(where / field.key, Title{field.title, field.label, field.unit()}, *number, field.least, field.most, field.unit());
    }

    /// An error where a name has a line break: in a table it could pass for lines of the program.
    void one_line(const Place& where, const std::string& name)
    {
        if (name.find_first_of("\n\r") != std::string::npos)
            error("line_break", where, say("The name has a line break; write it in one line."));
    }

    /// A name of one line that is not empty, not too long, and not taken.
    void name(const Place& where, const std::string& value, std::set<std::string>& taken)
    {
        one_line(where, value);
        if (value.empty()) error("empty_name", where, say("The name is empty; give one."));
        if (value.size() > 200) error("range", where, say("The name has {} bytes; 200 at most.", value.size()));
        if (!value.empty() && !taken.insert(value).second)
            error("duplicate_name", where, say("The name \"{}\" is taken; names must differ.", value));
    }

    int errors() const { return errors_; }

private:
    /// Rounded to three digits, or as many as it takes to show that it lies outside; a whole number in full.
    static double outside(double value, double least, double most)
    {
        const bool plain = std::abs(value) < 1e9 && value != std::round(value);
        for (int digits = 3; plain && digits < 17; ++digits) {
            const std::string text = fmt::format("{:.{}g}", value, digits);
            const double shown = std::strtod(text.c_str(), nullptr);
            if ((shown < least || shown > most) && text.find('e') == std::string::npos) return shown;
        }
        return value;
    }

    int errors_ = 0;
};

/// The end of a sentence that names an unknown word: "; did you mean "denim"?", or a full stop where no known word is near.
inline Argument or_near(const std::string& word, const std::vector<std::string>& known)
{
    const std::string near = nearest_word(word, known);
    return near.empty() ? Argument(".") : Argument(say("; did you mean \"{}\"?", near));
}

/// The parts of validate(), each in the order of the project file.
void validate_material(const Material& material, const Place& where, IssueList& list);
void validate_weave(const Fabric& fabric, const Place& where, IssueList& list);
void validate_sett(const Fabric& fabric, const FittedYarns& yarns, const Place& where, IssueList& list);
/// Returns the fabric as fitted, nullptr where it has an error.
std::shared_ptr<const FittedFabric> validate_fabric(const Design& design, const Fabric& fabric, const Place& where, IssueList& list);
void validate_liquid(const Liquid& liquid, const Place& where, IssueList& list);
void validate_experiment(const Design& design, const Experiment& experiment, const Place& where, IssueList& list);
void validate_climate(const Climate& climate, const Place& where, IssueList& list);
void validate_wear(const Design& design, const WearExperiment& wear, const Place& where, IssueList& list);
void validate_garment(const Design& design, const Garment& garment, const Place& where, IssueList& list);

} // namespace hygroloom
