// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "ui/lesson/lesson_controls.h"

#include "ui/basics/quantity.h"

#include <QBoxLayout>
#include <QFormLayout>
#include <QLabel>
#include <QSlider>

namespace hygroloom {

namespace {

constexpr int still_ms = 200;     // of a hand; each change loads the cloths anew
constexpr double drop_steps = 2;  // in an ul
constexpr double wind_steps = 10; // in a m/s
constexpr int steepest = 45;      // degrees

} // namespace

LessonControls::LessonControls(QWidget* parent) : QWidget(parent)
{
    auto* form = new QFormLayout(this);
    form->setContentsMargins(0, 0, 0, 0);
    drop_ = addSlider(form, tr("Drop"), qRound(drop_steps * least_drop_ul), qRound(drop_steps * most_drop_ul), &drop_text_);
    wind_ = addSlider(form, tr("Wind"), 0, qRound(wind_steps * 5), &wind_text_);
    temperature_ = addSlider(form, tr("Air"), 5, 60, &temperature_text_);
    humidity_ = addSlider(form, tr("Humidity"), 5, 95, &humidity_text_);
    tilt_ = addSlider(form, tr("Tilt"), 0, steepest, &tilt_text_);
    tilt_->setToolTip(
        "<p>" + tr("The lower edges of the cloths go down. Water in the yarns follows; drops that stand stay where they are.") + "</p>");
    for (QTimer* pause : {&air_pause_, &tilt_pause_}) {
        pause->setSingleShot(true);
        pause->setInterval(still_ms);
    }
    connect(drop_, &QSlider::valueChanged, this, [this] { Q_EMIT dropChanged(dropVolume()); });
    for (QSlider* slider : {wind_, temperature_, humidity_}) {
        connect(slider, &QSlider::valueChanged, &air_pause_, qOverload<>(&QTimer::start));
    }
    connect(tilt_, &QSlider::valueChanged, &tilt_pause_, qOverload<>(&QTimer::start));
    connect(&air_pause_, &QTimer::timeout, this, &LessonControls::airChanged);
    connect(&tilt_pause_, &QTimer::timeout, this, &LessonControls::tiltChanged);
    setLesson({});
}

QSlider* LessonControls::addSlider(QFormLayout* form, const QString& name, int least, int most, QLabel** value)
{
    auto* slider = new QSlider(Qt::Horizontal);
    slider->setRange(least, most);
    slider->setAccessibleName(name);
    *value = new QLabel;
    (*value)->setMinimumWidth((*value)->fontMetrics().horizontalAdvance("00.0 m/s0"));
    auto* row = new QHBoxLayout;
    row->addWidget(slider, 1);
    row->addWidget(*value);
    form->addRow(name, row);
    connect(slider, &QSlider::valueChanged, this, &LessonControls::showValues);
    return slider;
}

void LessonControls::setLesson(const Lesson& lesson)
{
    for (QSlider* slider : {drop_, wind_, temperature_, humidity_, tilt_}) { slider->blockSignals(true); }
    drop_->setValue(qRound(drop_steps * lesson.drop_ul));
    wind_->setValue(qRound(wind_steps * lesson.air.air_speed_m_s));
    temperature_->setValue(qRound(lesson.air.temperature_c));
    humidity_->setValue(qRound(100 * lesson.air.relative_humidity));
    tilt_->setValue(0);
    for (QSlider* slider : {drop_, wind_, temperature_, humidity_, tilt_}) { slider->blockSignals(false); }
    air_pause_.stop();
    tilt_pause_.stop();
    showValues();
}

void LessonControls::showValues()
{
    drop_text_->setText(tr("%1 µl").arg(shownNumber(dropVolume(), 1)));
    wind_text_->setText(tr("%1 m/s").arg(shownNumber(air().air_speed_m_s, 1)));
    temperature_text_->setText(tr("%1 °C").arg(temperature_->value()));
    humidity_text_->setText(tr("%1 %").arg(humidity_->value()));
    tilt_text_->setText(tr("%1°").arg(tilt_->value()));
}

double LessonControls::dropVolume() const { return drop_->value() / drop_steps; }

Climate LessonControls::air() const
{
    return {static_cast<double>(temperature_->value()), 0.01 * humidity_->value(), wind_->value() / wind_steps};
}

double LessonControls::tilt() const { return tilt_->value(); }

} // namespace hygroloom
