// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "ui/document/document.h"

#include "core/base/error.h"
#include "core/project/project_file.h"
#include "ui/document/sources.h"

#include <QCryptographicHash>
#include <QFile>
#include <QFileInfo>

#include <algorithm>

namespace hygroloom {

QByteArray hashOfFile(const QString& path)
{
    if (path.isEmpty()) { return {}; } // of a project that has no file
    QFile file(path);
    QCryptographicHash hash(QCryptographicHash::Sha256);
    return file.open(QIODevice::ReadOnly) && hash.addData(&file) ? hash.result() : QByteArray();
}

Document::Document(QObject* parent) : QObject(parent)
{
    state_.design = std::make_shared<const Design>();
    connect(&history_, &QUndoStack::cleanChanged, this, [this](bool clean) { Q_EMIT modifiedChanged(!clean); });
}

const Fabric* Document::fabric() const
{
    const auto& fabrics = state_.design->fabrics;
    return state_.fabric >= 0 && state_.fabric < static_cast<int>(fabrics.size()) ? &fabrics[static_cast<std::size_t>(state_.fabric)]
                                                                                  : nullptr;
}

const Experiment* Document::experiment() const
{
    const auto& experiments = state_.design->experiments;
    return state_.experiment >= 0 && state_.experiment < static_cast<int>(experiments.size())
               ? &experiments[static_cast<std::size_t>(state_.experiment)]
               : nullptr;
}

void Document::setFabricIndex(int index)
{
    if (index != state_.fabric) {
        DesignState state = state_;
        state.fabric = index;
        apply(std::move(state));
    }
}

void Document::setExperimentIndex(int index)
{
    if (index != state_.experiment) {
        DesignState state = state_;
        state.experiment = index;
        apply(std::move(state));
    }
}

bool Document::hasError() const { return has_error(issues_); }

bool Document::fabricHasError() const
{
    const Place own = Place("fabrics") / static_cast<std::size_t>(state_.fabric);
    return std::any_of(issues_.begin(), issues_.end(), [&](const Issue& issue) {
        return issue.severity == Severity::error && (issue.where.is_in(own) || issue.where.is_in("materials"));
    });
}

std::vector<const Issue*> Document::issuesAt(const std::string& where) const
{
    std::vector<const Issue*> found;
    for (const Issue& issue : issues_) {
        const std::string at = issue.where.text();
        if (at == where || where.starts_with(at + "[")) { found.push_back(&issue); }
    }
    std::stable_sort(found.begin(), found.end(), [](const Issue* a, const Issue* b) { return a->severity > b->severity; });
    return found;
}

void Document::edit(const QString& text, const std::string& field, const std::function<void(Design&)>& change)
{
    Design design = *state_.design;
    change(design);
    DesignState after = state_;
    after.design = std::make_shared<const Design>(std::move(design));
    history_.push(step(text, std::move(after), field));
}

void Document::editState(const QString& text, const std::function<void(Design&, DesignState&)>& change)
{
    Design design = *state_.design;
    DesignState after = state_;
    change(design, after);
    after.design = std::make_shared<const Design>(std::move(design));
    endStroke();
    history_.push(step(text, std::move(after), {}));
}

EditDesign* Document::step(const QString& text, DesignState after, const std::string& field)
{
    return new EditDesign([this](const DesignState& state) { apply(state); }, text, state_, std::move(after), field, stroke_);
}

void Document::apply(DesignState state)
{
    state_ = std::move(state);
    if (state_.folder != folder()) { // a step from before the project was saved elsewhere
        state_.design = std::make_shared<const Design>(movedSources(*state_.design, state_.folder, folder()));
        state_.folder = folder();
    }
    const int fabrics = static_cast<int>(state_.design->fabrics.size());
    const int experiments = static_cast<int>(state_.design->experiments.size());
    state_.fabric = std::clamp(state_.fabric, 0, std::max(0, fabrics - 1));
    state_.experiment = std::clamp(state_.experiment, 0, std::max(0, experiments - 1));
    Validation validation = validate_and_fit(*state_.design);
    issues_ = std::move(validation.issues);
    fitted_ = fabric() ? validation.fabrics[static_cast<std::size_t>(state_.fabric)] : nullptr;
    Q_EMIT designChanged();
}

QString Document::folder() const { return path_.isEmpty() ? QString() : QFileInfo(path_).absolutePath(); }

QString Document::title() const { return path_.isEmpty() ? title_ : QFileInfo(path_).fileName(); }

bool Document::open(const QString& path)
{
    try {
        replace(read_project(path.toStdString()), QFileInfo(path).absoluteFilePath(), {});
        return true;
    } catch (const Error& error) {
        Q_EMIT failed(QString::fromStdString(error.what()));
        return false;
    }
}

bool Document::openExample(const QString& path)
{
    try {
        const QString folder = QFileInfo(path).absolutePath();
        replace(movedSources(read_project(path.toStdString()), folder, {}), {},
                tr("Example: %1").arg(QFileInfo(path).completeBaseName().replace('-', ' ')));
        return true;
    } catch (const Error& error) {
        Q_EMIT failed(QString::fromStdString(error.what()));
        return false;
    }
}

bool Document::openUnsaved(const QString& file, const QString& path, const QString& title, const QString& origin)
{
    try {
        Design design = read_project(file.toStdString());
        if (path.isEmpty() && !origin.isEmpty()) { design = movedSources(std::move(design), QFileInfo(origin).absolutePath(), {}); }
        replace(std::move(design), path, title);
        history_.resetClean();
        return true;
    } catch (const Error& error) {
        Q_EMIT failed(QString::fromStdString(error.what()));
        return false;
    }
}

bool Document::save() { return saveAs(path_); }

bool Document::changedOnDisk() const
{
    const QByteArray now = hashOfFile(path_);
    return !now.isEmpty() && now != saved_;
}

bool Document::saveAs(const QString& path)
{
    const QString absolute = QFileInfo(path).absoluteFilePath();
    try {
        write_project(movedSources(*state_.design, folder(), QFileInfo(absolute).absolutePath()), absolute.toStdString());
    } catch (const Error& error) {
        Q_EMIT failed(QString::fromStdString(error.what()));
        return false;
    }
    history_.setClean();
    endStroke();
    saved_ = hashOfFile(absolute);
    if (absolute != path_) {
        path_ = absolute;
        if (state_.folder != folder()) { apply(state_); }
        Q_EMIT pathChanged();
    }
    return true;
}

void Document::take(const Design& design, const QString& title) { replace(design, {}, title); }

void Document::replace(Design design, const QString& path, const QString& title)
{
    history_.clear();
    endStroke();
    path_ = path;
    title_ = title;
    saved_ = hashOfFile(path);
    apply({std::make_shared<const Design>(std::move(design)), 0, 0, folder()});
    Q_EMIT replaced();
    Q_EMIT pathChanged();
    Q_EMIT modifiedChanged(false);
}

} // namespace hygroloom
