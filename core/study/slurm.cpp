// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "core/study/slurm.h"

#include "core/base/error.h"
#include "core/project/atomic_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <sstream>
#include <sys/wait.h>

namespace hygroloom {
namespace {

constexpr std::size_t rows_of_task = 16, most_tasks = 1000; // a task takes a second or two to begin; Slurm's usual limit is 1001

/// The slices that lack rows.
std::vector<std::size_t> slices(const KeptRows& kept, std::size_t tasks, bool retry_failed)
{
    std::vector<bool> lacks(tasks);
    for (std::size_t row = 0; row < kept.rows(); ++row)
        if (kept.state(row) == KeptRows::State::missing || (retry_failed && kept.state(row) == KeptRows::State::failed))
            lacks[row % tasks] = true;
    std::vector<std::size_t> numbers;
    for (std::size_t i = 0; i < tasks; ++i)
        if (lacks[i]) numbers.push_back(i + 1);
    return numbers;
}

/// "1-3,7" of 1, 2, 3, 7.
std::string ranges(const std::vector<std::size_t>& numbers)
{
    std::string text;
    for (std::size_t i = 0, end = 0; i < numbers.size(); i = end) {
        for (end = i + 1; end < numbers.size() && numbers[end] == numbers[end - 1] + 1;) ++end;
        text += fmt::format("{}{}", text.empty() ? "" : ",", numbers[i]);
        if (end > i + 1) text += fmt::format("-{}", numbers[end - 1]);
    }
    return text;
}

/// Where the tasks write. Slurm puts other things for what begins with %.
std::string log_pattern(const std::filesystem::path& folder)
{
    std::string pattern;
    for (const char c : (folder / "task-").string()) {
        if (c == '%' || c == '"' || c == '\\') pattern += c == '%' ? '%' : '\\';
        pattern += c;
    }
    return "\"" + pattern + "%a.log\"";
}

std::string script_of(const std::filesystem::path& folder, const SlurmOptions& how, std::size_t tasks, const std::string& array)
{
    std::string script = "#!/bin/sh\n#SBATCH --job-name=hygroloom\n#SBATCH --ntasks=1\n";
    script += fmt::format("#SBATCH --array={}\n#SBATCH --output={}\n", array, log_pattern(folder / "slurm"));
    if (how.gpus) script += "#SBATCH --gres=gpu:1\n";
    if (!how.sbatch.empty()) script += fmt::format("#SBATCH {}\n", how.sbatch);
    script += "# A task that is killed loses the runs under way; submitting again runs what is missing.\n";
    script += fmt::format("exec {} sweep -o {} --task \"$SLURM_ARRAY_TASK_ID/{}\" --quiet --backend {}{}", shell_word(how.program.string()),
                          shell_word(folder.string()), tasks, how.gpus ? "cuda" : how.backend, how.retry_failed ? " --retry-failed" : "");
    if (how.force) script += " --force";
    if (!how.gpus) script += " --threads 1 --jobs \"${SLURM_CPUS_PER_TASK:-1}\"";
    return script + "\n";
}

/// Submits a script and returns the job's number: "1234" or "1234;cluster" on a line of its own, between what a cluster tells its users.
std::string submitted(const std::filesystem::path& script)
{
    std::FILE* const sbatch = ::popen(fmt::format("exec sbatch --parsable {} 2>&1 < /dev/null", shell_word(script.string())).c_str(), "r");
    if (sbatch == nullptr) throw Error("No program can be started here.");
    std::string said;
    char block[4096];
    while (const std::size_t got = std::fread(block, 1, sizeof block, sbatch)) said.append(block, got);
    const int status = ::pclose(sbatch);
    if (WIFEXITED(status) && WEXITSTATUS(status) == 127)
        throw Error(
            fmt::format("Slurm is missing: the program sbatch is not here. Type sbatch {} on a machine of the cluster, or install the "
                        "package slurm-client.",
                        shell_word(script.string())));
    said.erase(said.find_last_not_of(" \n") + 1);
    if (status != 0)
        throw Error(fmt::format("Slurm does not take the job: {}{}", said,
                                said.find("array") != std::string::npos ? ". Give fewer tasks with --tasks." : ""));
    std::istringstream lines(said);
    for (std::string line; std::getline(lines, line);)
        if (const std::size_t digits = std::min(line.find_first_not_of("0123456789"), line.size());
            digits > 0 && (digits == line.size() || line[digits] == ';'))
            return line.substr(0, digits);
    throw Error(fmt::format("Slurm took the job, but does not say its number; see squeue. It says: {}", said));
}

} // namespace

std::string shell_word(const std::string& word)
{
    if (!word.empty() &&
        word.find_first_not_of("ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789_./=+-") == std::string::npos)
        return word;
    std::string inside;
    for (const char c : word) inside += c == '\'' ? std::string("'\\''") : std::string(1, c);
    return "'" + inside + "'";
}

SlurmJob submit_study(const Design& design, const Study& study, const std::filesystem::path& given, const StudyOptions& options,
                      const SlurmOptions& how)
{
    const std::filesystem::path folder = std::filesystem::absolute(given);
    const StudyFolder all = folder_of(design, study);
    const KeptRows kept = prepared_rows(all, folder, options);
    const std::size_t tasks = how.tasks > 0 ? static_cast<std::size_t>(how.tasks)
                                            : std::clamp((kept.rows() + rows_of_task - 1) / rows_of_task, std::size_t{1}, most_tasks);
    const std::vector<std::size_t> numbers = slices(kept, tasks, options.retry_failed);
    if (numbers.empty()) throw Error(folder.string() + ": No row is missing; make the table with --merge.");
    write_study_folder(all, folder);
    std::filesystem::create_directories(folder / "slurm");
    const std::filesystem::path script = folder / "slurm" / "job.sh";
    write_file(script, script_of(folder, how, tasks, ranges(numbers)));
    return {submitted(script), static_cast<int>(numbers.size())};
}

} // namespace hygroloom
