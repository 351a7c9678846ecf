// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "core/study/slurm.h"

#include "core/base/error.h"
#include "core/project/atomic_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstring>
#include <fcntl.h>
#include <optional>
#include <spawn.h>
#include <sstream>
#include <sys/mman.h>
#include <sys/wait.h>
#include <unistd.h>

extern char** environ;

namespace hygroloom {
namespace {

constexpr std::size_t rows_of_task = 16, most_tasks = 1000; // a task takes a second or two to begin; Slurm's usual limit is 1001

/// What a program printed, and how it ended. What a cluster tells its users goes to the errors, also where all is well.
struct Said {
    int code = -1;
    std::string text, errors;
};

void take_off_spaces(std::string& text)
{
    while (!text.empty() && std::isspace(static_cast<unsigned char>(text.back())) != 0) text.pop_back();
}

/// What was written to a file that has no name.
std::string written_to(int file)
{
    constexpr std::size_t most = 4096; // it is shown
    std::string text(most, '\0');
    text.resize(static_cast<std::size_t>(std::max<ssize_t>(0, ::pread(file, text.data(), most, 0))));
    take_off_spaces(text);
    return text;
}

Said ask(std::vector<std::string> words)
{
    int ends[2];
    const int errors = ::memfd_create("errors", MFD_CLOEXEC);
    if (errors < 0 || ::pipe2(ends, O_CLOEXEC) != 0)
        throw Error(fmt::format("{} cannot be started: {}.", words.front(), std::strerror(errno)));
    posix_spawn_file_actions_t actions;
    posix_spawn_file_actions_init(&actions);
    posix_spawn_file_actions_addopen(&actions, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
    posix_spawn_file_actions_adddup2(&actions, ends[1], STDOUT_FILENO);
    posix_spawn_file_actions_adddup2(&actions, errors, STDERR_FILENO);
    std::vector<char*> arguments;
    arguments.reserve(words.size() + 1);
    for (std::string& word : words) arguments.push_back(word.data());
    arguments.push_back(nullptr);
    pid_t child = 0;
    const int failure = ::posix_spawnp(&child, arguments[0], &actions, nullptr, arguments.data(), environ);
    posix_spawn_file_actions_destroy(&actions);
    ::close(ends[1]);
    Said said;
    char block[4096];
    for (ssize_t got = 0; failure == 0 && ((got = ::read(ends[0], block, sizeof block)) > 0 || (got < 0 && errno == EINTR));)
        if (got > 0) said.text.append(block, static_cast<std::size_t>(got));
    ::close(ends[0]);
    if (failure != 0) ::close(errors);
    if (failure != 0) throw Error(fmt::format("{} cannot be started: {}.", words.front(), std::strerror(failure)));
    int status = 0;
    while (::waitpid(child, &status, 0) < 0 && errno == EINTR) continue;
    said.code = WIFEXITED(status) ? WEXITSTATUS(status) : -1;
    take_off_spaces(said.text);
    said.errors = written_to(errors);
    ::close(errors);
    return said;
}

/// For the shell.
std::string quoted(const std::string& text)
{
    std::string inside;
    for (const char c : text) inside += c == '\'' ? std::string("'\\''") : std::string(1, c);
    return "'" + inside + "'";
}

std::string job_id(const std::filesystem::path& folder)
{
    std::error_code none;
    const std::filesystem::path file = folder / "slurm" / "job";
    if (!std::filesystem::exists(file, none)) return {};
    std::string id = read_file(file, 1000);
    id.erase(std::remove_if(id.begin(), id.end(), [](unsigned char c) { return std::isdigit(c) == 0; }), id.end());
    return id;
}

std::map<std::string, int> states_of(const std::string& id)
{
    const Said said = ask({"squeue", "--noheader", "--array", "--jobs", id, "--format", "%T"});
    std::map<std::string, int> states;
    if (said.code != 0 && said.errors.find("Invalid job id") == std::string::npos)
        throw Error(fmt::format("Slurm does not say what has become of job {}: {}", id, said.errors));
    if (said.code != 0) return states; // it has forgotten the job
    std::istringstream words(said.text);
    for (std::string word; words >> word;) ++states[word];
    return states;
}

/// The numbers of the slices that lack rows, "1-3,7".
std::string slices(const KeptRows& kept, int tasks, bool retry_failed, int& count)
{
    std::vector<bool> lacks(static_cast<std::size_t>(tasks));
    for (std::size_t row = 0; row < kept.rows(); ++row)
        if (kept.state(row) == KeptRows::State::missing || (retry_failed && kept.state(row) == KeptRows::State::failed))
            lacks[row % lacks.size()] = true;
    count = static_cast<int>(std::count(lacks.begin(), lacks.end(), true));
    std::string text;
    for (std::size_t i = 0; i < lacks.size();) {
        if (!lacks[i]) {
            ++i;
            continue;
        }
        std::size_t end = i;
        while (end < lacks.size() && lacks[end]) ++end;
        text += fmt::format("{}{}", text.empty() ? "" : ",", i + 1);
        if (end > i + 1) text += fmt::format("-{}", end);
        i = end;
    }
    return text;
}

std::string script_of(const std::filesystem::path& folder, const SlurmOptions& how, int tasks, const std::string& array)
{
    std::string script = "#!/bin/sh\n";
    script += "#SBATCH --job-name=hygroloom\n";
    script += fmt::format("#SBATCH --array={}\n", array);
    script += "#SBATCH --ntasks=1\n";
    if (how.gpus) script += "#SBATCH --gres=gpu:1\n";
    script += "# A task that is killed loses the runs under way; submitting again runs what is missing.\n";
    script += fmt::format("exec {} sweep -o {} --task \"$SLURM_ARRAY_TASK_ID/{}\" --quiet --backend {}{}", quoted(how.program.string()),
                          quoted(folder.string()), tasks, how.gpus ? "cuda" : how.backend, how.retry_failed ? " --retry-failed" : "");
    if (how.force) script += " --force";
    if (!how.gpus) script += " --threads 1 --jobs \"${SLURM_CPUS_PER_TASK:-1}\"";
    return script + "\n";
}

/// Where its tasks write: Slurm puts other things for what begins with %.
std::string log_pattern(const std::filesystem::path& folder)
{
    std::string pattern;
    for (const char c : (folder / "slurm" / "task-").string()) pattern += c == '%' ? std::string("%%") : std::string(1, c);
    return pattern + "%a.log";
}

/// What sbatch --parsable prints: "1234" or "1234;cluster", below what a cluster may tell its users.
std::string submitted_id(const std::string& text)
{
    const std::string last = text.substr(text.rfind('\n') + 1); // npos + 1 is 0
    const std::size_t digits = std::min(last.find_first_not_of("0123456789"), last.size());
    return digits > 0 && (digits == last.size() || last[digits] == ';') ? last.substr(0, digits) : "";
}

/// The highest number that a task of an array may have here; none where the cluster does not say.
std::optional<int> highest_task()
try {
    const Said said = ask({"scontrol", "show", "config"});
    std::istringstream words(said.text);
    for (std::string word, sign; words >> word;)
        if (int size = 0; word == "MaxArraySize" && words >> sign >> size && size > 1) return size - 1;
    return {};
} catch (const Error&) { // scontrol is not here
    return {};
}

/// Slices of the rows. Throws Error where more were asked for than the cluster takes.
int tasks_for(std::size_t rows, const SlurmOptions& how)
{
    const std::optional<int> highest = highest_task();
    if (how.tasks > 0 && highest && how.tasks > *highest)
        throw Error(fmt::format("--tasks must be from 1 to {} on this cluster (its MaxArraySize is {}); given is {}.", *highest,
                                *highest + 1, how.tasks));
    if (how.tasks > 0) return how.tasks;
    const std::size_t most = std::min(most_tasks, static_cast<std::size_t>(highest.value_or(static_cast<int>(most_tasks))));
    return static_cast<int>(std::clamp((rows + rows_of_task - 1) / rows_of_task, std::size_t{1}, most));
}

} // namespace

std::vector<std::string> shell_words(const std::string& text)
{
    std::vector<std::string> words;
    std::string word;
    char quote = 0;
    bool on = false;
    for (std::size_t i = 0; i < text.size(); ++i) {
        const char c = text[i];
        if (quote != 0) {
            if (c == quote)
                quote = 0;
            else
                word += c;
        } else if (c == '\'' || c == '"') {
            quote = c;
            on = true;
        } else if (std::isspace(static_cast<unsigned char>(c)) != 0) {
            if (on) words.push_back(std::exchange(word, {}));
            on = false;
        } else {
            word += c == '\\' && i + 1 < text.size() ? text[++i] : c;
            on = true;
        }
    }
    if (quote != 0) throw Error(fmt::format("--sbatch: A quote is not closed in: {}", text));
    if (on) words.push_back(word);
    return words;
}

std::string why_no_slurm()
{
    for (const char* program : {"sbatch", "squeue", "scancel"}) try {
            ask({program, "--version"});
        } catch (const Error&) {
            return fmt::format("Slurm is missing: the program {} is not here. Run this on a machine of the cluster, or install the package "
                               "slurm-client.",
                               program);
        }
    return {};
}

SlurmJob submit_study(const Design& design, const Study& study, const std::filesystem::path& given, const StudyOptions& options,
                      const SlurmOptions& how)
{
    if (const std::string reason = why_no_slurm(); !reason.empty()) throw Error(reason);
    const std::filesystem::path folder = std::filesystem::absolute(given);
    const std::vector<std::string> own = shell_words(how.sbatch);
    const StudyFolder all = folder_of(design, study);
    const KeptRows kept = prepared_rows(all, folder, options);
    if (const std::string before = job_id(folder); !before.empty() && !states_of(before).empty())
        throw Error(fmt::format("Job {} of this study is still on; see --status, or end it with --cancel.", before));
    SlurmJob job;
    job.tasks = tasks_for(kept.rows(), how);
    const std::string array = slices(kept, job.tasks, options.retry_failed, job.submitted);
    if (array.empty()) throw Error(folder.string() + ": No row is missing; make the table with --merge.");
    write_study_folder(all, folder);
    std::filesystem::create_directories(folder / "slurm");
    const std::filesystem::path script = folder / "slurm" / "job.sh";
    write_file(script, script_of(folder, how, job.tasks, array));
    std::vector<std::string> words{"sbatch", "--parsable", "--output", log_pattern(folder)};
    words.insert(words.end(), own.begin(), own.end());
    words.push_back(script.string());
    const Said said = ask(words);
    if (said.code != 0) {
        const bool by_array = said.errors.find("array") != std::string::npos;
        throw Error("Slurm refuses the job: " + said.errors + (by_array ? ". Give fewer tasks with --tasks." : ""));
    }
    job.id = submitted_id(said.text);
    if (job.id.empty()) throw Error(fmt::format("Slurm took the job, but does not say its number; see squeue. It says: {}", said.text));
    write_file(folder / "slurm" / "job", job.id + "\n");
    return job;
}

SlurmStatus study_status(const std::filesystem::path& folder)
{
    const StudyFolder study = read_study_folder(folder);
    const StudyFrame frame(study.study, study.design);
    KeptRows kept(frame.rows(), frame.metrics().size());
    kept.read_parts(folder, mark_of(study.project_text, study.study_text));
    SlurmStatus status;
    status.rows = frame.rows();
    status.done = kept.count(KeptRows::State::done);
    status.failed = kept.count(KeptRows::State::failed);
    status.id = job_id(folder);
    try {
        if (!status.id.empty()) status.states = states_of(status.id);
    } catch (const Error& error) {
        status.problem = error.what();
    }
    return status;
}

void cancel_study(const std::filesystem::path& folder)
{
    const std::string id = job_id(folder);
    if (id.empty()) throw Error(folder.string() + ": No job of this study was submitted.");
    if (const Said said = ask({"scancel", id}); said.code != 0) throw Error(fmt::format("Slurm does not end job {}: {}", id, said.errors));
}

} // namespace hygroloom
