// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "ui/picture/view_bar.h"

#include "ui/basics/appearance.h"
#include "ui/basics/design_undo.h"
#include "ui/basics/preferred_menu.h"

#include <QActionGroup>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QMenu>
#include <QSettings>
#include <QSignalBlocker>
#include <QSlider>
#include <QToolButton>

#include <algorithm>
#include <cmath>

namespace hygroloom {

namespace {

constexpr int section_steps = 1000;

QToolButton* menuButton(const QString& text, const QString& name, QMenu* menu)
{
    auto* button = new QToolButton;
    button->setText(text);
    button->setMenu(menu);
    button->setPopupMode(QToolButton::InstantPopup);
    button->setAccessibleName(name);
    button->setToolTip(name);
    button->setFocusPolicy(Qt::StrongFocus);
    return button;
}

} // namespace

ViewBar::ViewBar(TextileCanvas* canvas, QWidget* parent) : QToolBar(tr("View of the fabric"), parent), canvas_(canvas)
{
    setAccessibleName(windowTitle());
    setIconSize({16, 16});
    setMovable(false);
    buildViews();
    addSeparator();
    buildSection();
    addSeparator();
    buildMeasure();
    for (QAction* action : actions()) {
        if (auto* button = qobject_cast<QToolButton*>(widgetForAction(action))) {
            button->setFocusPolicy(Qt::StrongFocus);
            if (button->accessibleName().isEmpty()) { button->setAccessibleName(action->toolTip()); }
        }
    }
    setEnabled(canvas_ != nullptr);
    refreshSection();
}

QAction* ViewBar::addKeyed(const QString& text, int key, const QString& tip, std::function<void(TextileCanvas&)> work)
{
    // Single keys reach the window only when no field takes them, so they are no shortcuts of the actions.
    const QString shown = key == Qt::Key_Home ? tr("Home") : key ? QString(QChar(key)) : QString();
    auto* action = new QAction(shown.isEmpty() ? text : text + '\t' + shown, this);
    action->setStatusTip(tip);
    action->setToolTip(tip);
    action->setIconText(QString(text).remove('&'));
    connect(action, &QAction::triggered, this, [this, work = std::move(work)] {
        if (canvas_) { work(*canvas_); }
    });
    if (key) { keys_.emplace_back(key, action); }
    return action;
}

QMenu* ViewBar::choices(const QString& title, const QString& setting, const QStringList& names, int first,
                        const std::function<void(int)>& choose)
{
    auto* menu = new QMenu(title, this);
    auto* group = new QActionGroup(menu);
    const int saved =
        std::clamp(setting.isEmpty() ? first : QSettings().value(setting, first).toInt(), 0, static_cast<int>(names.size()) - 1);
    for (int i = 0; i < names.size(); ++i) {
        QAction* action = menu->addAction(names[i]);
        action->setCheckable(true);
        action->setChecked(i == saved);
        group->addAction(action);
        connect(action, &QAction::triggered, this, [setting, i, choose] {
            if (!setting.isEmpty()) { QSettings().setValue(setting, i); }
            choose(i);
        });
    }
    if (saved != first) { choose(saved); }
    return menu;
}

void ViewBar::buildViews()
{
    fit_ = addKeyed(tr("&Fit"), Qt::Key_F, tr("Show the whole fabric."), [](TextileCanvas& c) { c.fit(Framing::whole); });
    fit_->setIcon(themedIcon("fit"));
    views_ = new QMenu(tr("&Look From"), this);
    const auto look = [this](const QString& text, int key, const QString& tip, double turn, double lift) {
        views_->addAction(addKeyed(text, key, tip, [turn, lift](TextileCanvas& c) { c.lookFrom(turn, lift); }));
    };
    look(tr("F&ront"), Qt::Key_1, tr("Look along the warp."), 0, 0);
    look(tr("&Back"), Qt::Key_2, tr("Look against the warp."), 180, 0);
    look(tr("Ri&ght"), Qt::Key_3, tr("Look along the weft."), 90, 0);
    look(tr("&Left"), Qt::Key_4, tr("Look against the weft."), -90, 0);
    look(tr("&Top"), Qt::Key_7, tr("Look down on the fabric."), 0, 90);
    look(tr("B&ottom"), Qt::Key_8, tr("Look up at the fabric."), 0, -90);
    look(tr("&Isometric"), Qt::Key_0, tr("Isometric view."), -45, 35.264);
    views_->addSeparator();
    views_->addAction(addKeyed(tr("&Few Repeats"), Qt::Key_Home, tr("Show a few repeats in the middle."),
                               [](TextileCanvas& c) { c.fit(Framing::few_repeats); }));
    views_->addAction(addKeyed(tr("&Zoom to the Selected Yarn"), Qt::Key_Z, tr("Show a few crossings of the selected yarn."),
                               [](TextileCanvas& c) { c.zoomToSelection(); }));
    views_->addAction(
        addKeyed(tr("&Next Yarn"), Qt::Key_BracketRight, tr("Select the next yarn."), [](TextileCanvas& c) { c.selectNext(1); }));
    views_->addAction(
        addKeyed(tr("&Previous Yarn"), Qt::Key_BracketLeft, tr("Select the previous yarn."), [](TextileCanvas& c) { c.selectNext(-1); }));
    parallel_ = addKeyed(tr("P&arallel"), Qt::Key_5, tr("Parallel projection, without perspective."),
                         [this](TextileCanvas& c) { c.setParallel(parallel_->isChecked()); });
    parallel_->setCheckable(true);
    particles_ =
        addKeyed(tr("Pa&rticles"), Qt::Key_P, tr("Show the particles of free liquid instead of its surface."), [this](TextileCanvas& c) {
            QSettings().setValue("view/particles", particles_->isChecked());
            c.setParticlesShown(particles_->isChecked());
        });
    particles_->setCheckable(true);
    particles_->setChecked(QSettings().value("view/particles", false).toBool());
    if (canvas_) { canvas_->setParticlesShown(particles_->isChecked()); }
    shadow_ = addKeyed(tr("S&hadow"), 0, tr("Show the shadow of the fabric on the ground."), [this](TextileCanvas& c) {
        QSettings().setValue("view/shadow", shadow_->isChecked());
        c.setShadowShown(shadow_->isChecked());
    });
    shadow_->setCheckable(true);
    shadow_->setChecked(QSettings().value("view/shadow", true).toBool());
    if (canvas_) { canvas_->setShadowShown(shadow_->isChecked()); }
    swatches_ = choices(tr("S&watch"), "view/swatch", {tr("5 mm"), tr("2 cm"), tr("5 cm"), tr("10 cm")}, first_swatch, [this](int i) {
        swatch_ = i;
        Q_EMIT swatchChosen(i);
    });
    navigation_ = new QMenu(tr("&Mouse"), this);
    addPreferred(*navigation_, &Preferences::navigation, navigationNames());
    addWidget(menuButton(tr("View"), tr("Viewing direction"), views_));
    addAction(parallel_);
    addAction(particles_);
    addWidget(menuButton(tr("Swatch"), tr("Size of the swatch on screen"), swatches_));
}

void ViewBar::buildSection()
{
    sections_ = choices(tr("S&ection"), {}, {tr("&None"), tr("Across the &Warp"), tr("Across the We&ft"), tr("&Level")}, 0, [this](int i) {
        SectionPlane section = section_;
        section.across = static_cast<SectionPlane::Across>(i);
        if (canvas_ && section.across != section_.across) {
            // Through what is looked at.
            const QVector3D target = canvas_->camera().target();
            section.position = section.across == SectionPlane::Across::warp   ? target.y()
                               : section.across == SectionPlane::Across::weft ? target.x()
                                                                              : 0;
        }
        setSection(section);
    });
    addWidget(menuButton(tr("Section"), tr("Cut the fabric open"), sections_));
    slider_ = new QSlider(Qt::Horizontal);
    slider_->setRange(-section_steps, section_steps);
    slider_->setMinimumWidth(80);
    slider_->setMaximumWidth(180);
    slider_->setAccessibleName(tr("Position of the cut"));
    slider_->setToolTip(slider_->accessibleName());
    position_ = new QDoubleSpinBox;
    new DesignUndo(position_);
    position_->setDecimals(3);
    position_->setSuffix(tr(" mm"));
    position_->setAccessibleName(tr("Distance of the cut from the middle"));
    position_->setToolTip(position_->accessibleName());
    flip_ = new QAction(tr("Other Half"), this);
    flip_->setCheckable(true);
    flip_->setToolTip(tr("Keep the other half of the fabric."));
    section_parts_ = {addWidget(slider_), addWidget(position_), flip_};
    addAction(flip_);
    connect(slider_, &QSlider::valueChanged, this, [this](int value) {
        SectionPlane section = section_;
        section.position = half() * value / section_steps;
        setSection(section);
    });
    connect(position_, &QDoubleSpinBox::valueChanged, this, [this](double value) {
        SectionPlane section = section_;
        section.position = value;
        setSection(section);
    });
    connect(flip_, &QAction::toggled, this, [this](bool flipped) {
        SectionPlane section = section_;
        section.flipped = flipped;
        setSection(section);
    });
}

void ViewBar::buildMeasure()
{
    measure_ = addKeyed(tr("&Measure"), Qt::Key_M, tr("Measure the distance between two points on yarns."), [this](TextileCanvas& c) {
        c.setMeasuring(measure_->isChecked());
        measure_part_->setVisible(measure_->isChecked());
        c.setFocus();
    });
    measure_->setCheckable(true);
    addAction(measure_);
    measure_on_ = new QComboBox;
    measure_on_->addItems({tr("yarn centrelines"), tr("yarn surfaces")});
    measure_on_->setAccessibleName(tr("Measure between"));
    measure_on_->setToolTip(measure_on_->accessibleName());
    measure_part_ = addWidget(measure_on_);
    measure_part_->setVisible(false);
    connect(measure_on_, &QComboBox::currentIndexChanged, this, [this](int index) {
        if (canvas_) { canvas_->setMeasureOnAxes(index == 0); }
    });
    if (canvas_) {
        connect(canvas_, &TextileCanvas::measuringEnded, this, [this] {
            measure_->setChecked(false);
            measure_part_->setVisible(false);
        });
    }
}

double ViewBar::half() const
{
    return section_.across == SectionPlane::Across::warp   ? half_extent_.y()
           : section_.across == SectionPlane::Across::weft ? half_extent_.x()
                                                           : half_extent_.z();
}

void ViewBar::setSection(const SectionPlane& section)
{
    section_ = section;
    if (canvas_) { canvas_->setSection(section_); }
    refreshSection();
}

void ViewBar::setHalfExtent(const QVector3D& half)
{
    half_extent_ = half;
    refreshSection();
}

void ViewBar::refreshSection()
{
    const QSignalBlocker quiet_slider(slider_), quiet_position(position_), quiet_flip(flip_);
    const bool shown = section_.across != SectionPlane::Across::nothing;
    for (QAction* part : section_parts_) { part->setVisible(shown); }
    sections_->actions().at(static_cast<int>(section_.across))->setChecked(true);
    const double most = half();
    position_->setRange(-most, most);
    position_->setSingleStep(most > 1 ? 0.05 : 0.01);
    position_->setValue(section_.position);
    slider_->setValue(static_cast<int>(std::lround(section_steps * std::clamp(section_.position / most, -1.0, 1.0))));
    flip_->setChecked(section_.flipped);
}

bool ViewBar::pressKey(int key)
{
    for (const auto& [own, action] : keys_) {
        if (own == key && canvas_) {
            action->trigger();
            return true;
        }
    }
    return false;
}

void ViewBar::fillMenu(QMenu* menu)
{
    menu->addAction(fit_);
    menu->addMenu(views_);
    menu->addAction(parallel_);
    menu->addAction(particles_);
    menu->addAction(shadow_);
    menu->addMenu(swatches_);
    menu->addMenu(sections_);
    menu->addAction(measure_);
    menu->addMenu(navigation_);
}

} // namespace hygroloom
