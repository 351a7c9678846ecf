// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
// The OpenGL widget of the viewport: pointer, picture and overlay. Draws on demand only.
#pragma once

#include "ui/picture/pointer.h"
#include "ui/picture/prepared_view.h"
#include "ui/picture/sample_sum.h"
#include "ui/picture/textile_renderer.h"

#include <QElapsedTimer>
#include <QOpenGLFramebufferObject>
#include <QOpenGLWidget>
#include <QTimer>

namespace hygroloom {

/// What the overlay says; empty texts are left out.
struct PictureCaption {
    QString title;  ///< top left: what is shown
    QString clock;  ///< above it and larger, in pictures of a film; empty: none
    QString notice; ///< a state that must not be overlooked: "Results of an earlier design."
    QString legend; ///< what the colours mean; empty: no legend
    QString unit;
    double legend_maximum = 1;
    double legend_scale = 1; ///< number shown per value stored
    double legend_zero = 0;  ///< number shown of the value 0
    QString pointed;         ///< of a crossing's end, %1, and pick, %2: "End %1, pick %2 of the pores filled"
    bool operator==(const PictureCaption&) const = default;
};

/// A plane that cuts the fabric open. What lies before it is taken away.
struct SectionPlane {
    enum class Across { nothing, warp, weft, thickness };
    Across across = Across::nothing;
    double position = 0;  ///< mm, along the direction that it lies across
    bool flipped = false; ///< the other half is kept
    bool isCut() const { return across != Across::nothing; }
    bool operator==(const SectionPlane&) const = default;
};

/// A distance between two points of the fabric, in mm.
struct Measurement {
    QVector3D from;
    QVector3D to;
    double length() const { return (to - from).length(); }
};

/// Where a dragged drop is, and which of its lines it has snapped to.
struct DropSnap {
    QPointF at;        ///< mm
    bool on_x = false; ///< that along the warp
    bool on_y = false; ///< that along the weft
};

class TextileCanvas : public QOpenGLWidget {
    Q_OBJECT
public:
    explicit TextileCanvas(QWidget* parent = nullptr);
    ~TextileCanvas() override;

    /// nullptr shows nothing.
    void setView(std::shared_ptr<const PreparedView> view);
    /// More meshes of the fabric that is shown; others are ignored.
    void addMeshes(const PreparedView& view);
    const std::shared_ptr<const PreviewFabric>& fabric() const { return scene_.fabric(); }
    const FabricScene& scene() const { return scene_; }
    SceneView sceneView() const;
    /// That the picture takes.
    std::size_t triangles() const { return renderer_.triangles(scene_.batches()); }
    Framing framing() const { return framing_; }
    /// Since the picture was last framed.
    bool movedByHand() const { return moved_by_hand_; }
    /// How the next fabric will be framed, whatever was done by hand.
    void frameNext(Framing framing);
    /// Values of the whole's segments.
    void setWater(std::vector<float> values, double maximum);
    void setLiquid(LiquidSurface surface);
    /// Particles of free liquid instead of a surface round them.
    void setParticlesShown(bool shown);
    /// The cloth's shadow on a ground; there is none while colours are read from a legend.
    void setShadowShown(bool shown);
    void setCaption(const PictureCaption& caption);
    void setWaterColors(WaterColors colors);
    /// Crossing of the repeat that is pointed at elsewhere; negative for none.
    void setHighlight(int end, int pick);

    /// From where a face of the fabric is seen.
    void fit(Framing framing);
    void lookFrom(double turn, double lift);
    void setParallel(bool parallel);
    void setSection(const SectionPlane& section);
    /// Clicks then set the two ends of a distance, on yarn centrelines or yarn surfaces.
    void setMeasuring(bool measuring);
    bool measuring() const { return measuring_; }
    /// Where drops are to fall, mm from the sample's middle; the chosen one is marked as such.
    void setDrops(std::vector<QPointF> drops, int chosen);
    const std::vector<QPointF>& drops() const { return drops_; }
    /// Whether markers can be dragged, and drops added with a double-click and deleted with Delete.
    void setDropsEditable(bool editable);
    /// Clicks then say where a drop is to fall.
    void setPlacing(bool placing);
    void setMeasureOnAxes(bool onAxes) { measure_on_axes_ = onAxes; }
    std::optional<Measurement> measurement() const;
    YarnNumber selected() const { return selected_; }
    void select(const YarnNumber& yarn);
    /// The neighbour of the selected yarn; one in the middle of the picture when none is selected.
    void selectNext(int step);
    void zoomToSelection();
    /// Shortens or lengthens the distance, about the middle.
    void zoomBy(double factor);
    void zoomAt(double factor, const QPointF& at);
    void turnBy(const QPointF& pixels);
    const Camera& camera() const { return camera_; }
    void setCamera(const Camera& camera);
    /// Presses the mouse's button there without moving it.
    void click(const QPointF& at);

    /// The picture with its overlay, complete and with smooth edges, however long that takes.
    QImage picture();
    /// The camera moves, or did a moment ago: coarser where the picture is slow.
    bool moves() const { return moving_; }
    /// Whether all is drawn that will be while nothing moves.
    bool rests() const { return !moving_ && !scene_changed_ && sampled_times_ >= samplesWanted(); }

Q_SIGNALS:
    /// Numbered as the whole is, from its first crossing; negative when none is pointed at.
    void crossingHovered(int end, int pick);
    void yarnSelected(const hygroloom::YarnNumber& yarn);
    void measured();
    void measuringEnded();
    /// mm from the sample's middle, along the weft and along the warp.
    void placed(const QPointF& at);
    void placingEnded();
    void dropChosen(int drop);
    void dropMoved(int drop, const QPointF& to);
    void dropAdded(const QPointF& at);
    void dropRemoved(int drop);
    void meshesWanted();
    /// It looks from elsewhere, by hand or by itself.
    void cameraMoved();
    void failed(const QString& sentence);

protected:
    void initializeGL() override;
    void paintGL() override;
    void resizeGL(int width, int height) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void mouseDoubleClickEvent(QMouseEvent* event) override;
    void wheelEvent(QWheelEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    void leaveEvent(QEvent* event) override;
    void changeEvent(QEvent* event) override;

private:
    using Drag = PointerDrag;
    PictureColors colors() const;
    bool showsLegend() const { return !caption_.legend.isEmpty() && water_colors_ != WaterColors::natural; }
    void frame(Framing framing);
    void redraw(bool moving);
    void drawAnew();
    /// What is shown changes, which prolongs no motion.
    void changed();
    void takeView();
    void drawScene();
    void drawSample();
    void adaptToMotion(double seconds);
    bool refines() const;
    int samplesWanted() const;
    void drawOverlay(QPainter& painter);
    double drawClock(QPainter& painter, const QColor& ink);
    void drawTitle(QPainter& painter, const QColor& ink);
    void drawAxes(QPainter& painter, const QColor& ink);
    void drawHover(QPainter& painter, const QColor& ink);
    void drawHighlight(QPainter& painter);
    void drawMeasurement(QPainter& painter, const QColor& ink);
    // textile_drops.cpp
    void drawDrops(QPainter& painter);
    void drawSnap(QPainter& painter);
    QPointF markerOf(const QPointF& drop) const;
    int dropAt(const QPointF& at) const;
    DropSnap snapped(const QPointF& place, int but) const;
    bool takeDrop(const QMouseEvent& event);
    void dragDrop(const QPointF& at);
    void dropDrop();
    void putDropBack();
    // the others
    QString selectionText() const;
    void hover(const QPointF& at);
    std::optional<CutPlane> cut() const;
    std::optional<YarnHit> hit(const QPointF& at) const;
    std::optional<QVector3D> onPlane(const QPointF& at) const;
    std::optional<QVector3D> pointUnder(const QPointF& at) const;

    TextileRenderer renderer_;
    FabricScene scene_;
    bool usable_ = false;
    Camera camera_;
    Camera told_; ///< when cameraMoved() was last emitted
    Framing framing_ = Framing::few_repeats;
    bool moved_by_hand_ = false;                  ///< since the last fit; until then new fabrics are fitted
    std::shared_ptr<const PreparedView> waiting_; ///< until there is a context
    std::vector<float> water_;
    double water_maximum_ = 1;
    bool water_changed_ = false;
    LiquidSurface liquid_;
    bool liquid_changed_ = false;
    bool particles_shown_ = false;
    bool shadow_shown_ = true;
    PictureCaption caption_;
    WaterColors water_colors_ = WaterColors::blue;
    QPoint highlight_{-1, -1};
    QPoint hovered_{-1, -1};
    YarnNumber selected_;
    SectionPlane section_;
    bool measuring_ = false;
    bool measure_on_axes_ = true;
    bool placing_ = false;
    std::vector<QPointF> drops_; ///< mm
    int chosen_drop_ = -1;
    bool drops_editable_ = false;
    int dragged_drop_ = -1; ///< whose marker is held
    QPointF drop_before_;   ///< mm, where it was taken
    DropSnap snap_;
    std::vector<QVector3D> measured_; ///< up to two
    QPointF pointer_;
    QPointF pressed_at_;
    QPointF dragged_from_;
    QVector3D pivot_;
    Drag drag_ = Drag::none;
    bool pressed_ = false;
    bool dragged_ = false;
    bool moving_ = false;
    bool scene_changed_ = true;
    bool was_fading_ = false;
    double still_seconds_ = 0; ///< what the last still picture took
    int moving_step_ = 0;      ///< how much less is drawn while it moves
    int least_step_ = 0;       ///< that is quick enough in this motion
    QElapsedTimer since_drawn_;
    QElapsedTimer rested_; ///< since the last still picture
    bool film_is_quick_ = true;
    int refine_at_rest_ = 1; ///< as preferred when it was last looked
    QTimer still_;
    QTimer fade_;
    QTimer more_;       ///< until the next sample is drawn
    SampleSum samples_; ///< of the picture at rest
    int sampled_times_ = 0;
    bool sample_due_ = false;
    bool at_once_ = false;                              ///< a few samples in one go
    std::unique_ptr<QOpenGLFramebufferObject> sampled_; ///< linear light, as the next
    std::unique_ptr<QOpenGLFramebufferObject> light_;
    std::unique_ptr<QOpenGLFramebufferObject> coarse_picture_; ///< while it moves
    std::unique_ptr<QOpenGLFramebufferObject> scene_picture_;
};

} // namespace hygroloom
