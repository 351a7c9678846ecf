// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// Fields of one yarn of the chosen fabric: the warp's, the weft's, or the chosen one of those in its stripes.
#pragma once

#include "core/design/yarn_sections.h"
#include "core/project/library.h"
#include "ui/panels/design_form.h"

class QCheckBox;
class QMenu;
class QToolButton;

namespace hygroloom {

class CountEdit;
enum class YarnUse { warp, weft, stripes };

class YarnPanel : public QObject {
    Q_OBJECT
public:
    /// Adds its rows to the form. The weft's can follow the warp's; those of the stripes are there while the fabric has extra yarns.
    YarnPanel(DesignForm& form, YarnUse use, QObject* parent);

    const FormSection& section() const { return section_; }
    /// Opens the section, that of the stripes at this extra yarn, from 1.
    void choose(int yarn);

    /// The yarn as the library has it, dyed so where it comes in colours; without one it keeps its colour.
    void take(const LibraryYarn& from, const std::optional<Color>& color = {});
    /// Into the library at path; a yarn of that name is replaced. The yarn refers to it then. Throws FileError.
    void keep(const QString& name, const QString& path);
    /// All yarns of the project that are the same as this one become the library's, in one step of the history. How many fabrics changed.
    int replaceEverywhere(const LibraryYarn& by);
    /// All yarns of the project that refer to the library at path become as they are there, in one step of the history, or none where
    /// they are so already. Throws FileError.
    std::vector<YarnUpdate> updateFrom(const QString& path);
    /// What changed, for the user.
    static QString saidOf(const std::vector<YarnUpdate>& updates);

Q_SIGNALS:
    /// The values of this one of the project's own fibres are to be edited.
    void fibreRequested(int fibre);

private:
    using Write = std::function<void(Yarn&, std::optional<double>)>;
    const Yarn* yarn() const;
    Yarn& yarnOf(Fabric& fabric) const;
    std::size_t stripe() const;
    bool isWarp() const { return use_ != YarnUse::weft; }
    void addSameAsWarp();
    void addChoice();
    /// Changes the yarn, and the weft with the warp while it is the same.
    std::function<void(Design&, std::optional<double>)> writing(Write change);
    void editYarn(const QString& undo, const std::string& field, const std::function<void(Yarn&)>& change);
    std::string path(const char* field) const;
    void addLibrary();
    void fillLibrary(QMenu& menu);
    void askToKeep();
    void updateAndSay();
    void refreshLibrary();
    void addMaterials();
    using PartName = std::string* (*)(Yarn&); ///< the name of a fibre in a yarn; nullptr: it has none there
    /// Beside a choice of a fibre: a button for makeOwn().
    void addOwnButton(QComboBox* choice, const QString& name, PartName part);
    /// Makes the project's own of a fibre, which the yarn takes, or asks for the one that it is.
    void makeOwn(PartName part);
    void addCore();
    void addColor();
    void addSizes();
    void addTwist();
    void addPlies();
    QComboBox* addDirection(const char* key, TwistDirection Yarn::*member);
    void refresh();
    void refreshSame();
    void refreshChoice();
    void refreshDerived();
    void refreshMaterials();
    void refreshOwnButtons();

    DesignForm& form_;
    YarnUse use_;
    QString kind_; ///< in the history: "weft"
    FormSection section_;
    FormOwner<Yarn> row_;
    int stripe_ = 0; ///< of the extra yarns, the one last chosen; there may be fewer now
    QToolButton* library_ = nullptr;
    QComboBox* choice_ = nullptr;
    QCheckBox* same_ = nullptr;
    QComboBox* fibre_ = nullptr;
    QComboBox* blend_ = nullptr;
    std::vector<std::pair<QToolButton*, PartName>> own_buttons_;
    QComboBox* core_ = nullptr;
    QComboBox* twist_direction_ = nullptr;
    QComboBox* ply_direction_ = nullptr;
    QToolButton* color_ = nullptr;
    QuantityEdit* twist_ = nullptr;
    QuantityEdit* plies_ = nullptr;
    QuantityEdit* ply_twist_ = nullptr;
    QuantityEdit* share_ = nullptr;
    QuantityEdit* core_share_ = nullptr;
    QuantityEdit* diameter_ = nullptr;
    CountEdit* count_ = nullptr;
    QuantityEdit* packing_ = nullptr;
    QLabel* count_note_ = nullptr;
    QLabel* diameter_note_ = nullptr;
    QLabel* crimp_ = nullptr;
    QLabel* pore_ = nullptr;
    std::optional<FreeYarn> free_; ///< that the shown yarn makes, where it can be fitted
    std::vector<QWidget*> fields_;
    std::string unlinked_; ///< fabric whose equal weft the user wants to edit apart
};

} // namespace hygroloom
