// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "ui/lesson/lesson_scene.h"

#include "core/base/units.h"
#include "ui/basics/color_map.h"
#include "ui/lesson/lesson_words.h"
#include "ui/lesson/magnifier.h"
#include "ui/lesson/water_disc.h"

#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>

#include <algorithm>
#include <cmath>
#include <utility>

namespace hygroloom {

namespace {

constexpr int frame_ms = 25;           // 40 pictures a second
constexpr double stream_pause = 0.2;   // s, from drop to drop
constexpr double margin = 22;          // pixels, round a cloth
constexpr double texts_in_height = 45; // of the height, one over another
constexpr double line_height = 1.35;   // sizes of its text
constexpr double words_lines = 11;     // under a cloth
constexpr double head_lines = 3;       // over it: the clock of a picture, and its title
constexpr int least_text = 12;         // pixels
constexpr double side_m = 1e-3 * lesson_cloth_mm;
constexpr double small_step = 1e-3, large_step = 5e-3; // m, of the marker
constexpr double marker_radius = 9;                    // pixels
const QColor table_color("#4a4038"), table_edge("#332b25"), words_color("#f4efe6"), quiet_words("#cfc6b8"), notice_color("#ffd08a");

} // namespace

LessonScene::LessonScene(QWidget* parent) : QWidget(parent)
{
    setMouseTracking(true);
    setFocusPolicy(Qt::StrongFocus);
    setCursor(Qt::CrossCursor);
    setMinimumSize(480, 360);
    setAttribute(Qt::WA_OpaquePaintEvent);
    setAccessibleName(tr("Table with cloths"));
    setAccessibleDescription(tr("1 to 4 choose a cloth, arrows move the marker on it, Enter drops water there."));
    connect(&frames_, &QTimer::timeout, this, &LessonScene::goOn);
    frames_.setTimerType(Qt::PreciseTimer);
    frames_.start(frame_ms);
}

void LessonScene::setTable(LessonTable* table, const std::vector<LessonCloth>& cloths)
{
    table_ = table;
    cloths_.clear();
    pours_ = by_keys_ = false;
    ledger_size_ = {};
    marked_ = 0;
    marker_ = {};
    for (const LessonCloth& cloth : cloths) {
        cloths_.emplace_back();
        cloths_.back().title = QString::fromStdString(cloth.title);
    }
    update();
}

void LessonScene::setExplains(bool explains)
{
    explains_ = explains;
    update();
}

void LessonScene::goOn()
{
    if (!table_ || !isVisible()) { return; }
    const double clock = table_->clock();
    if (pours_ && clock >= last_drop_ + stream_pause) { dropAt(pointer_); }
    for (int k = 0; k < static_cast<int>(cloths_.size()); ++k) { refresh(k); }
    update();
}

void LessonScene::refresh(int place)
{
    Cloth& cloth = cloths_[static_cast<std::size_t>(place)];
    cloth.view = table_->view(place);
    cloth.failure = QString::fromStdString(table_->failure(place));
    if (!cloth.failure.isEmpty()) { cloth.falling.clear(); }
    if (!cloth.view) { return; }
    std::erase_if(cloth.falling, [&](const Falling& drop) { return drop.number <= cloth.view->released + cloth.view->refused; });
}

int LessonScene::textSize() const { return std::max(least_text, static_cast<int>(std::ceil(height() / texts_in_height))); }

QRectF LessonScene::clothArea(int cloth) const
{
    const auto count = static_cast<int>(cloths_.size());
    if (cloth < 0 || cloth >= count) { return {}; }
    const double cell = static_cast<double>(width()) / count;
    const double words = words_lines * line_height * textSize(), head = head_lines * line_height * textSize();
    const double side = std::max(40.0, std::min(cell - 2 * margin, height() - words - head));
    const double top = std::max(head, 0.5 * (height() - side - words));
    return {(cloth + 0.5) * cell - 0.5 * side, top, side, side};
}

int LessonScene::clothAt(const QPointF& at) const
{
    for (int k = 0; k < static_cast<int>(cloths_.size()); ++k) {
        if (clothArea(k).contains(at)) { return k; }
    }
    return -1;
}

QPointF LessonScene::placeOn(int cloth, const QPointF& at) const
{
    const QRectF area = clothArea(cloth);
    const double metre = side_m / area.width();
    return {(at.x() - area.center().x()) * metre, (area.center().y() - at.y()) * metre};
}

QPointF LessonScene::pixelOf(int cloth, const QPointF& place) const
{
    const QRectF area = clothArea(cloth);
    return area.center() + QPointF(place.x(), -place.y()) * (area.width() / side_m);
}

void LessonScene::drop(int cloth, double x, double y)
{
    Cloth& on = cloths_.at(static_cast<std::size_t>(cloth));
    if (!table_) { return; }
    refresh(cloth); // it may have been laid out since the last picture
    if (!on.view || !on.failure.isEmpty()) { return; }
    Falling falling{++on.asked, x, y, 1e-9 * drop_ul_, {}};
    falling.since.start();
    on.falling.push_back(falling);
    table_->drop(cloth, x, y, falling.volume);
    last_drop_ = table_->clock();
    click_.start();
    update();
}

void LessonScene::dropAt(const QPointF& at)
{
    const int cloth = clothAt(at);
    if (cloth < 0) { return; }
    const QPointF place = placeOn(cloth, at);
    drop(cloth, place.x(), place.y());
}

void LessonScene::chooseCloth(int cloth)
{
    if (cloth < 0 || cloth >= static_cast<int>(cloths_.size())) { return; }
    marked_ = cloth;
    by_keys_ = true;
    update();
}

void LessonScene::moveMarker(double x, double y)
{
    by_keys_ = true;
    const auto within = [](double at) { return std::clamp(at, -0.5 * side_m, 0.5 * side_m); };
    marker_ = {within(marker_.x() + x), within(marker_.y() + y)};
    update();
}

QImage LessonScene::picture(const QString& clock)
{
    QImage image = grab().toImage();
    QPainter painter(&image);
    QFont large = font();
    large.setPixelSize(std::max(20, textSize()));
    painter.setFont(large);
    painter.setPen(words_color);
    painter.drawText(rect().adjusted(12, 8, -12, -8), Qt::AlignLeft | Qt::AlignTop, clock);
    return image;
}

bool LessonScene::markerSeen() const { return by_keys_ && hasFocus() && marked_ < static_cast<int>(cloths_.size()); }

QPointF LessonScene::lookedAt() const { return markerSeen() ? pixelOf(marked_, marker_) : pointer_; }

void LessonScene::dropAtMarker(bool again)
{
    if (!table_ || marked_ >= static_cast<int>(cloths_.size())) { return; }
    by_keys_ = true;
    if (again && table_->clock() < last_drop_ + stream_pause) { return; }
    drop(marked_, marker_.x(), marker_.y());
}

void LessonScene::keyPressEvent(QKeyEvent* event)
{
    const double step = event->modifiers().testFlag(Qt::ShiftModifier) ? large_step : small_step;
    switch (event->key()) {
    case Qt::Key_Left: return moveMarker(-step, 0);
    case Qt::Key_Right: return moveMarker(step, 0);
    case Qt::Key_Up: return moveMarker(0, step);
    case Qt::Key_Down: return moveMarker(0, -step);
    case Qt::Key_Return:
    case Qt::Key_Enter: return dropAtMarker(event->isAutoRepeat());
    default: return QWidget::keyPressEvent(event);
    }
}

void LessonScene::mousePressEvent(QMouseEvent* event)
{
    pointer_ = event->position();
    by_keys_ = false;
    if (event->button() != Qt::LeftButton || clothAt(pointer_) < 0) { return; }
    dropAt(pointer_);
    pours_ = true;
}

void LessonScene::mouseMoveEvent(QMouseEvent* event)
{
    if (event->position() == pointer_) { return; }
    pointer_ = event->position();
    by_keys_ = false;
    if (explains_) { update(); }
}

void LessonScene::mouseReleaseEvent(QMouseEvent* event)
{
    if (event->button() == Qt::LeftButton) { pours_ = false; }
}

void LessonScene::leaveEvent(QEvent*)
{
    pointer_ = {-1, -1};
    pours_ = false;
}

void LessonScene::drawCloth(QPainter& painter, int place)
{
    Cloth& cloth = cloths_[static_cast<std::size_t>(place)];
    const QRectF area = clothArea(place);
    painter.fillRect(area.translated(4, 5), QColor(0, 0, 0, 70));
    if (!cloth.view) {
        painter.fillRect(area, table_edge);
        painter.setPen(words_color);
        QFont plain = font();
        plain.setPixelSize(textSize());
        painter.setFont(plain);
        if (cloth.failure.isEmpty()) {
            painter.drawText(area.adjusted(12, 12, -12, -12), Qt::AlignCenter | Qt::TextWordWrap, tr("This cloth is being laid out."));
        }
        return;
    }
    const int side = std::max(8, qRound(area.width() * devicePixelRatioF()));
    const Textile& textile = cloth.view->run->textile;
    const bool anew = !cloth.look || cloth.look->side() != side;
    if (anew) { cloth.look = std::make_unique<ClothLook>(cloth.view->run->design.fabrics.at(0), textile, side); }
    const bool same = !anew && cloth.drawn && cloth.drawn->frame == cloth.view->frame;
    painter.drawImage(area, same ? cloth.look->now() : cloth.look->at(textile, *cloth.view->frame));
    cloth.drawn = cloth.view;
}

void LessonScene::drawCaps(QPainter& painter, int place)
{
    const Cloth& cloth = cloths_[static_cast<std::size_t>(place)];
    if (!cloth.view) { return; }
    const QRectF area = clothArea(place);
    const double pixels = area.width() / side_m;
    const auto at = [&](double x, double y) { return area.center() + QPointF(x, -y) * pixels; };
    for (const FrameCap& cap : cloth.view->frame->caps) {
        if (cap.base > 0) {
            drawStanding(painter, at(cap.x, cap.y), cap.base * pixels, cap.height / cap.base);
        } else {
            const double ball = std::cbrt(3 * cap.volume / (4 * pi));
            drawFalling(painter, at(cap.x, cap.y), ball * pixels, std::max(0.0, cap.height - 2 * ball) * pixels);
        }
    }
    for (const Falling& drop : cloth.falling) { // seen at once, before the cloth's next look
        const double ball = std::cbrt(3 * drop.volume / (4 * pi)), height = 1e-3 * drop_height_mm;
        drawFalling(painter, at(drop.x, drop.y), ball * pixels, height * pixels);
    }
}

/// Over what was seen of it last.
void LessonScene::drawFailure(QPainter& painter, int place) const
{
    const QString& failure = cloths_[static_cast<std::size_t>(place)].failure;
    if (failure.isEmpty()) { return; }
    const QRectF area = clothArea(place);
    painter.fillRect(area, QColor(0, 0, 0, 170));
    QFont large = font();
    large.setPixelSize(std::clamp(qRound(area.width() / 20), least_text, std::max(20, textSize())));
    painter.setFont(large);
    painter.setPen(notice_color);
    painter.drawText(area.adjusted(12, 12, -12, -12), Qt::AlignCenter | Qt::TextWordWrap,
                     tr("This cloth is not simulated any more. %1").arg(failure));
}

void LessonScene::drawTitle(QPainter& painter, int place) const
{
    const QString& title = cloths_[static_cast<std::size_t>(place)].title;
    const QRectF area = clothArea(place);
    const double wide = static_cast<double>(width()) / static_cast<double>(cloths_.size()) - 12, high = line_height * textSize();
    QFont bold = font();
    bold.setBold(true);
    bold.setPixelSize(textSize());
    while (bold.pixelSize() > least_text && QFontMetricsF(bold).horizontalAdvance(title) > wide) {
        bold.setPixelSize(bold.pixelSize() - 1);
    }
    painter.setFont(bold);
    painter.setPen(words_color);
    painter.drawText(QRectF(area.center().x() - 0.5 * wide, area.top() - high - 4, wide, high), Qt::AlignCenter,
                     QFontMetricsF(bold).elidedText(title, Qt::ElideRight, wide));
}

void LessonScene::drawWords(QPainter& painter, int place) const
{
    drawTitle(painter, place);
    const Cloth& cloth = cloths_[static_cast<std::size_t>(place)];
    if (!cloth.view) { return; }
    const QRectF area = clothArea(place);
    const double cell = static_cast<double>(width()) / static_cast<double>(cloths_.size()), middle = area.center().x();
    const double most = middle + 0.5 * cell - 8, left = std::min(area.left(), most - std::min(cell - 16, 13.0 * textSize())),
                 wide = most - left;
    QFont plain = font();
    plain.setPixelSize(textSize());
    painter.setFont(plain);
    painter.setPen(words_color);
    double y = area.bottom() + 10;
    for (const QString& line : scoreLines(cloth.view->score)) {
        QRectF taken;
        painter.drawText(QRectF(left, y, wide, height() - y), Qt::AlignLeft | Qt::AlignTop | Qt::TextWordWrap, line, &taken);
        y = std::max(y + line_height * textSize(), taken.bottom());
    }
    drawLedger(painter, {left, y + 4, wide, height() - y - 8}, *cloth.view);
}

/// Where the water is, and what is to be said of the cloth; in smaller letters where the window has no room for it.
void LessonScene::drawLedger(QPainter& painter, const QRectF& room, const ClothView& view) const
{
    const QString water = waterInWords(water_shares(view.frame->ledger, view.bound_at_start, view.released)), notice = noticeOf(view);
    constexpr int how = Qt::AlignLeft | Qt::AlignTop | Qt::TextWordWrap;
    QFont plain = font();
    if (std::exchange(ledger_size_, size()) != size()) { ledger_text_ = textSize(); }
    plain.setPixelSize(ledger_text_);
    const auto heightOf = [&](const QString& text) {
        return text.isEmpty() ? 0.0 : QFontMetricsF(plain).boundingRect(QRectF(0, 0, room.width(), 1e4), how, text).height() + 4;
    };
    while (plain.pixelSize() > least_text && heightOf(water) + heightOf(notice) > room.height()) {
        plain.setPixelSize(plain.pixelSize() - 1);
    }
    ledger_text_ = plain.pixelSize(); // it does not grow again, so that no sentence jumps from picture to picture
    painter.setFont(plain);
    painter.setPen(quiet_words);
    painter.drawText(room, how, water);
    if (notice.isEmpty()) { return; }
    painter.setPen(notice_color);
    painter.drawText(room.adjusted(0, heightOf(water), 0, 0), how, notice);
}

void LessonScene::drawGlass(QPainter& painter) const
{
    const QPointF at = lookedAt();
    const int cloth = explains_ ? clothAt(at) : -1;
    if (cloth < 0 || !cloths_[static_cast<std::size_t>(cloth)].view) { return; }
    const QPointF place = placeOn(cloth, at);
    const YarnLook yarn = yarnAt(*cloths_[static_cast<std::size_t>(cloth)].view, place.x(), place.y());
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(QPen(words_color, 2));
    painter.drawEllipse(at, 4, 4);
    const double scale = std::max(1.0, textSize() / 16.0), radius = scale * magnifier_radius, away = radius + 16;
    const double x = at.x() + away + radius > width() ? at.x() - away : at.x() + away;
    const double y = std::clamp(at.y(), radius + 4, std::max(radius + 4, height() - radius - 4));
    painter.save();
    painter.translate(x, y);
    painter.scale(scale, scale);
    drawMagnifier(painter, {0, 0}, yarn, font());
    painter.restore();
}

void LessonScene::drawMarker(QPainter& painter) const
{
    if (!markerSeen()) { return; }
    const QPointF at = pixelOf(marked_, marker_);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setBrush(Qt::NoBrush);
    for (const QPen& pen : {QPen(table_edge, 5), QPen(notice_color, 2)}) { // seen on any cloth
        painter.setPen(pen);
        painter.drawEllipse(at, marker_radius, marker_radius);
        for (const QPointF& way : {QPointF(1, 0), QPointF(-1, 0), QPointF(0, 1), QPointF(0, -1)}) {
            painter.drawLine(at + way * (0.5 * marker_radius), at + way * (1.6 * marker_radius));
        }
    }
}

void LessonScene::paintEvent(QPaintEvent*)
{
    QPainter painter(this);
    painter.fillRect(rect(), table_color);
    for (int k = 0; k < static_cast<int>(cloths_.size()); ++k) {
        drawCloth(painter, k);
        drawCaps(painter, k);
        drawFailure(painter, k);
        drawWords(painter, k);
    }
    if (!cloths_.empty()) {
        const QRectF first = clothArea(0);
        drawScaleBar(painter, first.bottomLeft() + QPointF(8, -8), lesson_cloth_mm / first.width(), 0.6 * first.width(), QColor("#1d2327"),
                     QColor(255, 255, 255, 150));
    }
    drawMarker(painter);
    drawGlass(painter);
    if (click_.isValid()) {
        slowest_answer_ = std::max(slowest_answer_, 1e-9 * static_cast<double>(click_.nsecsElapsed()));
        click_.invalidate();
    }
}

} // namespace hygroloom
