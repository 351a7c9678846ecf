// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// The table with its cloths from above: a click drops water, holding drops a stream, and each cloth says what it has come to.
#pragma once

#include "core/lesson/lesson_table.h"
#include "ui/lesson/cloth_look.h"

#include <QElapsedTimer>
#include <QTimer>
#include <QWidget>

#include <map>

namespace hygroloom {

class LessonScene : public QWidget {
    Q_OBJECT
public:
    explicit LessonScene(QWidget* parent = nullptr);

    /// nullptr: nothing is on the table. The table must outlive its use here.
    void setTable(LessonTable* table, const std::vector<LessonCloth>& cloths);
    void setDrop(double volume_ul) { drop_ul_ = volume_ul; }
    void setExplains(bool explains);
    bool explains() const { return explains_; }
    /// Puts a drop over a place of a cloth, m from its middle; not on one that is not simulated.
    void drop(int cloth, double x, double y);
    /// Shows the marker that keys move, on that cloth, where there is one.
    void chooseCloth(int cloth);
    /// Pixels of this widget that a cloth takes; empty where there is none.
    QRectF clothArea(int cloth) const;
    /// Pixels, of the words under a cloth, over it and of the clock: a 45th of the height, so that the last row of a class reads them.
    int textSize() const;
    /// s of wall time from a click to the next picture, the longest so far; less than 0: none yet.
    double slowestAnswer() const { return slowest_answer_; }
    /// As it looks now, with a clock in its corner.
    QImage picture(const QString& clock);
    QSize sizeHint() const override { return {960, 720}; }

protected:
    void paintEvent(QPaintEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void leaveEvent(QEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;

private:
    /// A drop that was asked for and that no frame has yet.
    struct Falling {
        int number = 0; ///< among those of its cloth
        double x = 0, y = 0, volume = 0;
        QElapsedTimer since;
    };
    struct Cloth {
        QString title;
        std::unique_ptr<ClothLook> look;
        std::shared_ptr<const ClothView> view, drawn;
        QString failure; ///< why it is not simulated any more
        int asked = 0;
        std::vector<Falling> falling;
    };

    void dropAt(const QPointF& at);
    void dropAtMarker(bool again);
    void moveMarker(double x, double y);
    bool markerSeen() const;
    /// Where one looks: at the marker or the pointer.
    QPointF lookedAt() const;
    void goOn();
    void refresh(int place);
    int clothAt(const QPointF& at) const;
    /// m from the cloth's middle.
    QPointF placeOn(int cloth, const QPointF& at) const;
    QPointF pixelOf(int cloth, const QPointF& place) const;
    void drawCloth(QPainter& painter, int place);
    void drawFailure(QPainter& painter, int place) const;
    void drawCaps(QPainter& painter, int place);
    void drawTitle(QPainter& painter, int place) const;
    void drawWords(QPainter& painter, int place) const;
    void drawLedger(QPainter& painter, const QRectF& room, const ClothView& view) const;
    void drawGlass(QPainter& painter) const;
    void drawMarker(QPainter& painter) const;

    LessonTable* table_ = nullptr;
    std::vector<Cloth> cloths_;
    QTimer frames_;
    double drop_ul_ = 5;
    double last_drop_ = 0; // s of the clock, of a stream
    bool pours_ = false, explains_ = false;
    QPointF pointer_{-1, -1};
    int marked_ = 0; ///< cloth that the marker is on
    QPointF marker_; ///< m from its middle
    bool by_keys_ = false;
    QElapsedTimer click_; // valid until the next picture
    double slowest_answer_ = -1;
    mutable int ledger_text_ = 0; ///< pixels, of the words about water, in a window of that size
    mutable QSize ledger_size_;
};

} // namespace hygroloom
