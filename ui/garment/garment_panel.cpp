// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "ui/garment/garment_panel.h"

#include "core/base/error.h"
#include "ui/basics/core_words.h"
#include "ui/basics/elided_combo.h"
#include "ui/basics/icon_button.h"
#include "ui/basics/language.h"
#include "ui/basics/name_dialog.h"
#include "ui/basics/typed_value.h"
#include "ui/document/sources.h"
#include "ui/garment/fields.h"
#include "ui/garment/garment_edits.h"
#include "ui/garment/lining_field.h"
#include "ui/garment/panel_table.h"

#include <QFileDialog>
#include <QFileInfo>
#include <QFormLayout>
#include <QLabel>
#include <QListWidget>
#include <QMenu>
#include <QMimeData>
#include <QVBoxLayout>

#include <algorithm>

namespace hygroloom {

namespace {

/// Its rows travel as names of fabrics.
class FabricList : public QListWidget {
public:
    FabricList()
    {
        setDragEnabled(true);
        setDragDropMode(DragOnly);
        setFrameShape(NoFrame);
        setAccessibleName(GarmentPanel::tr("Fabrics to drag onto panels"));
        setToolTip(GarmentPanel::tr("Drag a fabric onto a panel. A double click cuts all panels from it."));
    }

protected:
    QStringList mimeTypes() const override { return {fabric_mime}; }
    QMimeData* mimeData(const QList<QListWidgetItem*>& items) const override
    {
        auto* dragged = new QMimeData;
        if (!items.isEmpty()) { dragged->setData(fabric_mime, items.front()->text().toUtf8()); }
        return dragged;
    }
};

/// Of a table of sweat rates, or the file that takes its place.
QString nameOfTable(const std::string& table)
{
    if (table == "taylor-2013 rest") { return GarmentPanel::tr("At rest, Taylor 2013"); }
    if (table == "taylor-2013 exercise") { return GarmentPanel::tr("Exercise, Taylor 2013"); }
    return coreWord(table);
}

QString aboutSweat()
{
    return GarmentPanel::tr(
        "Sweat of each zone of the body: Taylor and Machado-Moreira 2013, table 4, or a CSV with the columns zone and g_m2_h.");
}

} // namespace

GarmentPanel::GarmentPanel(GarmentChoice& choice, QWidget* parent)
    : QScrollArea(parent), choice_(choice), panels_(new PanelTable(choice)), fabrics_(new FabricList)
{
    setWidgetResizable(true);
    setFrameShape(NoFrame);
    setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    auto* all = new QWidget;
    auto* layout = new QVBoxLayout(all);
    layout->setContentsMargins(8, 8, 8, 8);
    layout->setSpacing(6);
    layout->addWidget(makeHead());
    layout->addWidget(size_ = makeSize());
    layout->addWidget(heading(tr("Panels")));
    panels_->setMinimumHeight(150);
    layout->addWidget(panels_, 3);
    auto* lining = new LiningField(choice);
    layout->addWidget(lining);
    connect(panels_->selectionModel(), &QItemSelectionModel::selectionChanged, lining, [this, lining] {
        const QModelIndexList chosen = panels_->selectionModel()->selectedRows();
        lining->setPanel(chosen.isEmpty() ? -1 : chosen.front().row());
    });
    layout->addWidget(heading(tr("Fabrics")));
    fabrics_->setMinimumHeight(60);
    layout->addWidget(fabrics_, 1);
    layout->addWidget(heading(tr("Wearer")));
    layout->addWidget(makeWearer());
    setWidget(all);
    connect(fabrics_, &QListWidget::itemActivated, this, [this](const QListWidgetItem* item) {
        if (choice_.garment()) { cutAllFrom(choice_.document(), choice_.garmentIndex(), item->text().toStdString()); }
    });
    connect(&choice_, &GarmentChoice::changed, this, &GarmentPanel::refresh);
    connect(&choice_.document(), &Document::replaced, &reader_, &NewestJob::drop);
    refresh();
}

/// All of its width: it scrolls up and down only.
QSize GarmentPanel::minimumSizeHint() const
{
    constexpr int readable = 300; // names of panels and fabrics
    const int own = widget() ? widget()->minimumSizeHint().width() : 0;
    return {std::max(readable, own + 2), QScrollArea::minimumSizeHint().height()};
}

QWidget* GarmentPanel::makeHead()
{
    garments_ = new ElidedCombo;
    garments_->setAccessibleName(tr("Garment"));
    garments_->setMinimumContentsLength(8);
    garments_->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    connect(garments_, &QComboBox::activated, &choice_, &GarmentChoice::setGarmentIndex);
    auto* add = iconButton("add", tr("Add a garment"));
    auto* kinds = new QMenu(add);
    for (const std::string& kind : built_in_garments()) {
        connect(kinds->addAction(tr("Built-in %1").arg(coreWord(kind))), &QAction::triggered, this,
                [this, kind] { choice_.setGarmentIndex(addBuiltInGarment(choice_.document(), kind)); });
    }
    kinds->addSeparator();
    connect(kinds->addAction(tr("Pattern or Mesh from a File…")), &QAction::triggered, this, &GarmentPanel::addFile);
    add->setMenu(kinds);
    add->setPopupMode(QToolButton::InstantPopup);
    rename_ = iconButton("rename", tr("Rename the garment"));
    connect(rename_, &QToolButton::clicked, this, [this] {
        if (!choice_.garment()) { return; }
        const int garment = choice_.garmentIndex();
        NameDialog dialog(
            tr("Rename the Garment"), QString::fromStdString(choice_.garment()->name),
            [this, garment](const QString& name) { return whyNotGarmentName(*choice_.document().design(), garment, name); }, this);
        if (dialog.exec() == QDialog::Accepted) { renameGarment(choice_.document(), garment, dialog.name()); }
    });
    remove_ = iconButton("delete", tr("Remove the garment and its experiments"));
    connect(remove_, &QToolButton::clicked, this, &GarmentPanel::removeChosen);
    auto* row = new QWidget;
    auto* layout = new QHBoxLayout(row);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(4);
    layout->addWidget(garments_, 1);
    layout->addWidget(add);
    layout->addWidget(rename_);
    layout->addWidget(remove_);
    return row;
}

QWidget* GarmentPanel::makeSize()
{
    auto* box = new QWidget;
    auto* grid = new QGridLayout(box);
    grid->setContentsMargins(0, 0, 0, 0);
    grid->setVerticalSpacing(4);
    for (const Field<BuiltInGarment>& size : fields_of<BuiltInGarment>()) { addSize(grid, size); }
    return box;
}

/// Two fields a row.
void GarmentPanel::addSize(QGridLayout* grid, const Field<BuiltInGarment>& size)
{
    const int place = static_cast<int>(sizes_.size());
    const QString name = coreWord(size.label);
    auto* edit = rowField<BuiltInGarment>(choice_.document(), size.key, [this, &size, name](double typed) {
        editGarment(choice_.document(), tr("change %1").arg(withinSentence(name)), choice_.garmentIndex(), size.key,
                    [&](Garment& garment) { set_field(size, garment.built_in, typed); });
    });
    edit->setMinimumWidth(edit->fontMetrics().horizontalAdvance("1000 mm") + 24);
    auto* label = new QLabel(name);
    label->setBuddy(edit);
    grid->addWidget(label, place / 2, 2 * (place % 2));
    grid->addWidget(edit, place / 2, 2 * (place % 2) + 1);
    sizes_.push_back({label, edit, size});
}

QWidget* GarmentPanel::makeWearer()
{
    skin_ = rowField<Wearer>(choice_.document(), "skin_temperature_c", [this](double value) {
        editGarment(choice_.document(), tr("change skin temperature"), choice_.garmentIndex(), "wearer.skin_temperature_c",
                    [&](Garment& garment) { garment.wearer.skin_temperature_c = value; });
    });
    gap_ = quantityField(choice_.document(), Quantity::length(0, 100), tr("Gap between skin and cloth"), [this](double value) {
        editGarment(choice_.document(), tr("change gap"), choice_.garmentIndex(), "wearer.gap_mm.default",
                    [&](Garment& garment) { garment.wearer.gap_mm["default"] = value; });
    });
    gap_->setHelp(tr("Air between skin and cloth, where the project names no other gap for a zone; 0: they touch."));
    sweat_ = new ElidedCombo;
    sweat_->setAccessibleName(tr("Sweat rates of the zones"));
    sweat_->setMinimumContentsLength(8);
    sweat_->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    sweat_->setToolTip("<p>" + aboutSweat().toHtmlEscaped() + "</p>");
    connect(sweat_, &QComboBox::activated, this, &GarmentPanel::chooseSweat);
    auto* box = new QWidget;
    auto* form = new QFormLayout(box);
    form->setContentsMargins(0, 0, 0, 0);
    form->setVerticalSpacing(4);
    form->addRow(tr("Skin"), skin_);
    form->addRow(tr("Gap to skin"), gap_);
    form->addRow(tr("Sweat"), sweat_);
    return box;
}

void GarmentPanel::chooseSweat(int index)
{
    std::string zones;
    if (index < static_cast<int>(sweat_tables().size())) {
        zones = sweat_tables()[static_cast<std::size_t>(index)];
    } else if (index + 1 < sweat_->count()) {
        return; // the file that is in use
    } else {
        const QString folder = choice_.document().folder();
        const QString file = QFileDialog::getOpenFileName(this, tr("Sweat Rates"), folder, tr("Tables of zones (*.csv)"));
        if (file.isEmpty()) {
            refresh();
            return;
        }
        zones = sourceFrom(folder, file).toStdString();
    }
    editGarment(choice_.document(), tr("choose sweat rates"), choice_.garmentIndex(), {},
                [&](Garment& garment) { garment.wearer.zones = zones; });
}

void GarmentPanel::addFile()
{
    const QString file =
        QFileDialog::getOpenFileName(this, tr("Add a Garment"), QString::fromStdString(choice_.base().string()),
                                     tr("Patterns and meshes (*.json *.obj *.glb *.gltf *.fbx *.ply *.dae);;All files (*)"));
    if (file.isEmpty()) { return; }
    reader_.run([this, file](const NewestJob::Turn& turn) {
        QString problem;
        try {
            Garment garment;
            garment.source = file.toStdString();
            read_pattern(garment, {}, [&turn] { return turn.outdated(); });
        } catch (const Cancelled&) {
            return;
        } catch (const std::exception& error) {
            problem = QString::fromUtf8(error.what());
        }
        turn.deliver([this, file, problem] {
            if (problem.isEmpty()) {
                choice_.setGarmentIndex(addGarmentFile(choice_.document(), file));
            } else {
                Q_EMIT problemFound(problem);
            }
        });
    });
}

void GarmentPanel::removeChosen()
{
    commitTypedValue(*window());
    if (choice_.garment()) { removeGarment(choice_.document(), choice_.garmentIndex()); }
}

void GarmentPanel::refresh()
{
    const Design& design = *choice_.document().design();
    QStringList names;
    for (const Garment& garment : design.garments) { names << QString::fromStdString(garment.name); }
    const Garment* garment = choice_.garment();
    setChoices(garments_, names, garment ? choice_.garmentIndex() : -1);
    rename_->setEnabled(garment != nullptr);
    rename_->setToolTip(garment ? tr("Rename the garment") : tr("There is no garment to rename."));
    remove_->setEnabled(garment != nullptr);
    remove_->setToolTip(garment ? tr("Remove the garment and its experiments") : tr("There is no garment to remove."));
    for (QWidget* part : {static_cast<QWidget*>(skin_), static_cast<QWidget*>(gap_), static_cast<QWidget*>(sweat_),
                          static_cast<QWidget*>(panels_), static_cast<QWidget*>(garments_)}) {
        part->setEnabled(garment != nullptr);
    }
    const QStringList fabrics = namesOf(design.fabrics);
    QStringList shown;
    for (int i = 0; i < fabrics_->count(); ++i) { shown << fabrics_->item(i)->text(); }
    if (shown != fabrics) {
        fabrics_->clear();
        for (int i = 0; i < fabrics.size(); ++i) { fabrics_->addItem(new QListWidgetItem(colorIcon(fabricColor(i)), fabrics[i])); }
    }
    size_->setVisible(garment && garment->is_built_in());
    if (!garment) { return; }
    const std::string where = "garments[" + std::to_string(choice_.garmentIndex()) + "].";
    for (const SizeField& field : sizes_) {
        const SizeRange range = size_range(garment->built_in.kind, field.row);
        field.edit->setRange(range.least, range.most);
        field.edit->setValue(field_value(field.row, garment->built_in));
        field.edit->setIssues(choice_.document().issuesAt(where + "source." + field.row.key));
        const bool used = !field.row.is_written || field.row.is_written(garment->built_in);
        field.edit->setEnabled(used);
        field.label->setEnabled(used);
    }
    sizes_.front().label->setText(garment->built_in.kind == "leggings" ? tr("Hip") : tr("Chest"));
    skin_->setValue(garment->wearer.skin_temperature_c);
    skin_->setIssues(choice_.document().issuesAt(where + "wearer.skin_temperature_c"));
    gap_->setValue(garment->gap_of("default"));
    gap_->setIssues(choice_.document().issuesAt(where + "wearer.gap_mm.default"));
    QStringList tables;
    for (const std::string& table : sweat_tables()) { tables << nameOfTable(table); }
    const QString zones = nameOfTable(garment->wearer.zones);
    if (!tables.contains(zones)) { tables << zones; }
    const int current = static_cast<int>(tables.indexOf(zones));
    setChoices(sweat_, tables << tr("From a CSV File…"), current);
    sweat_->setToolTip("<p>" + zones.toHtmlEscaped() + "</p><p>" + aboutSweat().toHtmlEscaped() + "</p>");
    updateGeometry(); // what is shown may need more width
}

} // namespace hygroloom
