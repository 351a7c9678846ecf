// SPDX-License-Identifier: GPL-3.0-or-later WITH AdditionRef-CUDA-runtime
#include "ui/basics/appearance.h"

#include <QAbstractSpinBox>
#include <QApplication>
#include <QComboBox>
#include <QDBusConnection>
#include <QDBusMessage>
#include <QDBusVariant>
#include <QFile>
#include <QIconEngine>
#include <QPainter>
#include <QProxyStyle>
#include <QSettings>
#include <QStyleFactory>
#include <QStyleOption>
#include <QSvgRenderer>

#include <algorithm>

// Q_INIT_RESOURCE works outside of namespaces only.
static void initializeResources() { Q_INIT_RESOURCE(resources); }

namespace hygroloom {

namespace {

const QStringList looks{"desktop", "light", "dark", "contrast"}; // as Appearance has them, in the settings

/// Draws an SVG whose strokes are "#000" in a colour of the palette.
class PaletteIcon : public QIconEngine {
public:
    PaletteIcon(QString name, QByteArray drawing, std::optional<Severity> severity)
        : name_(std::move(name)), drawing_(std::move(drawing)), severity_(severity)
    {
    }

    void paint(QPainter* painter, const QRect& rect, QIcon::Mode mode, QIcon::State) override
    {
        const QPalette palette = QApplication::palette();
        const auto group = mode == QIcon::Disabled ? QPalette::Disabled : QPalette::Active;
        const auto role = mode == QIcon::Selected ? QPalette::HighlightedText : QPalette::WindowText;
        const QColor color = severity_ ? severityColor(*severity_, palette) : palette.color(group, role);
        QSvgRenderer renderer(QByteArray(drawing_).replace("#000", color.name().toLatin1()));
        if (mode == QIcon::Disabled) { painter->setOpacity(0.55); } // quiet lines alone look as if it could be pressed
        renderer.render(painter, QRectF(rect));
    }

    QPixmap pixmap(const QSize& size, QIcon::Mode mode, QIcon::State state) override
    {
        QPixmap pixmap(size);
        pixmap.fill(Qt::transparent);
        QPainter painter(&pixmap);
        paint(&painter, QRect(QPoint(), size), mode, state);
        return pixmap;
    }

    QIconEngine* clone() const override { return new PaletteIcon(*this); }
    QString key() const override { return "hygroloom-palette-icon"; }

private:
    QString name_;
    QByteArray drawing_;
    std::optional<Severity> severity_;
};

QIcon paletteIcon(const QString& name, std::optional<Severity> severity)
{
    useResources();
    QFile file(":/icons/" + name + ".svg");
    if (!file.open(QIODevice::ReadOnly)) { return {}; }
    return QIcon(new PaletteIcon(name, file.readAll(), severity));
}

QPalette palette(const QColor& window, const QColor& base, const QColor& button, const QColor& text, const QColor& quiet,
                 const QColor& accent, const QColor& onAccent, const QColor& line)
{
    QPalette p;
    p.setColor(QPalette::Window, window);
    p.setColor(QPalette::Base, base);
    p.setColor(QPalette::AlternateBase, window);
    p.setColor(QPalette::Button, button);
    for (const auto role : {QPalette::WindowText, QPalette::Text, QPalette::ButtonText, QPalette::ToolTipText, QPalette::BrightText}) {
        p.setColor(role, text);
        p.setColor(QPalette::Disabled, role, quiet);
    }
    p.setColor(QPalette::PlaceholderText, quiet);
    p.setColor(QPalette::ToolTipBase, base);
    p.setColor(QPalette::Highlight, accent);
    p.setColor(QPalette::Disabled, QPalette::Highlight, line);
    p.setColor(QPalette::HighlightedText, onAccent);
    p.setColor(QPalette::Link, accent);
    p.setColor(QPalette::LinkVisited, accent);
    p.setColor(QPalette::Light, button.lighter(110));
    p.setColor(QPalette::Midlight, button.lighter(104));
    p.setColor(QPalette::Mid, line);
    p.setColor(QPalette::Dark, line.darker(115));
    p.setColor(QPalette::Shadow, line.darker(150));
    return p;
}

QPalette lightPalette() { return palette("#f3f4f5", "#ffffff", "#fbfbfc", "#1d2327", "#666e75", "#0b6aa8", "#ffffff", "#c3c8cd"); }

QPalette darkPalette() { return palette("#2b3035", "#1d2124", "#363c42", "#e6e9eb", "#98a1a8", "#4aa3df", "#0d1114", "#454c53"); }

/// White and yellow on black.
QPalette contrastPalette() { return palette("#000000", "#000000", "#1a1a1a", "#ffffff", "#c8c8c8", "#ffd800", "#000000", "#8c8c8c"); }

/// Outlines whatever can be typed into or pressed in the colour of text; Fusion's own outlines are darker than the window.
class OutlinedStyle : public QProxyStyle {
public:
    OutlinedStyle() : QProxyStyle(QStyleFactory::create("Fusion")) {}

    void drawPrimitive(PrimitiveElement element, const QStyleOption* option, QPainter* painter, const QWidget* widget) const override
    {
        QProxyStyle::drawPrimitive(element, option, painter, widget);
        const QWidget* owner = widget ? widget->parentWidget() : nullptr;
        if (qobject_cast<const QComboBox*>(owner) || qobject_cast<const QAbstractSpinBox*>(owner)) {
            return; // has an outline
        }
        if (element == PE_IndicatorRadioButton) {
            outline(option, option->rect, painter, true);
        } else if (element == PE_Frame || element == PE_FrameLineEdit || element == PE_PanelLineEdit || element == PE_PanelButtonCommand ||
                   element == PE_IndicatorCheckBox || element == PE_FrameMenu || element == PE_PanelTipLabel) {
            outline(option, option->rect, painter);
        }
    }

    void drawComplexControl(ComplexControl control, const QStyleOptionComplex* option, QPainter* painter,
                            const QWidget* widget) const override
    {
        QProxyStyle::drawComplexControl(control, option, painter, widget);
        if (control == CC_ComboBox || control == CC_SpinBox) {
            outline(option, option->rect, painter);
        } else if (control == CC_Slider) {
            const QRect handle = subControlRect(control, option, SC_SliderHandle, widget);
            outline(option, subControlRect(control, option, SC_SliderGroove, widget), painter);
            painter->fillRect(handle, option->palette.brush(QPalette::Button));
            outline(option, handle, painter);
        }
    }

private:
    static void outline(const QStyleOption* option, const QRect& rect, QPainter* painter, bool round = false)
    {
        const bool focus = option->state & State_HasFocus;
        const auto group = option->state & State_Enabled ? QPalette::Active : QPalette::Disabled;
        painter->save();
        painter->setBrush(Qt::NoBrush);
        painter->setPen(QPen(option->palette.color(group, focus ? QPalette::Highlight : QPalette::WindowText), focus ? 2 : 1));
        const QRect inside = rect.adjusted(focus ? 1 : 0, focus ? 1 : 0, -1, -1);
        if (round) {
            painter->setRenderHint(QPainter::Antialiasing);
            painter->drawEllipse(QRectF(inside).adjusted(0.5, 0.5, -0.5, -0.5));
        } else {
            painter->drawRect(inside);
        }
        painter->restore();
    }
};

/// Fusion draws what can be ticked darker than the window, which in a dark window cannot be seen.
class DarkStyle : public QProxyStyle {
public:
    DarkStyle() : QProxyStyle(QStyleFactory::create("Fusion")) {}

    void drawPrimitive(PrimitiveElement element, const QStyleOption* option, QPainter* painter, const QWidget* widget) const override
    {
        QProxyStyle::drawPrimitive(element, option, painter, widget);
        if (element != PE_IndicatorCheckBox && element != PE_IndicatorRadioButton) { return; }
        const bool enabled = option->state & State_Enabled;
        painter->save();
        painter->setRenderHint(QPainter::Antialiasing);
        painter->setBrush(Qt::NoBrush);
        painter->setPen(option->palette.color(enabled ? QPalette::PlaceholderText : QPalette::Mid));
        const QRectF inside = QRectF(option->rect).adjusted(0.5, 0.5, -0.5, -0.5);
        if (element == PE_IndicatorCheckBox) {
            painter->drawRoundedRect(inside, 2, 2);
        } else {
            painter->drawEllipse(inside);
        }
        painter->restore();
    }
};

bool desktopIsDark()
{
    if (!QDBusConnection::sessionBus().isConnected()) { return false; }
    QDBusMessage question = QDBusMessage::createMethodCall("org.freedesktop.portal.Desktop", "/org/freedesktop/portal/desktop",
                                                           "org.freedesktop.portal.Settings", "Read");
    question << "org.freedesktop.appearance"
             << "color-scheme";
    const QDBusMessage answer = QDBusConnection::sessionBus().call(question, QDBus::Block, 200);
    if (answer.type() != QDBusMessage::ReplyMessage || answer.arguments().isEmpty()) { return false; }
    QVariant value = answer.arguments().first();
    while (value.canConvert<QDBusVariant>()) { value = value.value<QDBusVariant>().variant(); }
    return value.toUInt() == 1;
}

} // namespace

void useResources() { initializeResources(); }

void applyAppearance(Appearance appearance)
{
    const bool contrast = appearance == Appearance::contrast;
    const bool dark = appearance == Appearance::dark || (appearance == Appearance::desktop && desktopIsDark());
    QStyle* style = nullptr;
    if (contrast) {
        style = new OutlinedStyle;
    } else {
        style = dark ? new DarkStyle : QStyleFactory::create("Fusion");
    }
    QApplication::setStyle(style);
    QApplication::setPalette(contrast ? contrastPalette() : dark ? darkPalette() : lightPalette());
}

Appearance savedAppearance()
{
    const auto found = looks.indexOf(QSettings().value("appearance").toString());
    return static_cast<Appearance>(std::max<qsizetype>(0, found));
}

void saveAppearance(Appearance appearance) { QSettings().setValue("appearance", looks[static_cast<int>(appearance)]); }

bool isDark(const QPalette& palette) { return palette.color(QPalette::Window).lightnessF() < 0.5F; }

QIcon themedIcon(const QString& name) { return paletteIcon(name, {}); }

QColor severityColor(Severity severity, const QPalette& palette)
{
    const bool dark = isDark(palette);
    switch (severity) {
    case Severity::error: return dark ? "#ff7b72" : "#b3261e";
    case Severity::warning: return dark ? "#e3b341" : "#8f5a00";
    case Severity::note: break;
    }
    return palette.color(QPalette::Link);
}

QIcon severityIcon(Severity severity)
{
    return paletteIcon(severity == Severity::error ? "error" : severity == Severity::warning ? "warning" : "note", severity);
}

QString severityName(Severity severity)
{
    switch (severity) {
    case Severity::error: return QApplication::translate("hygroloom", "Error");
    case Severity::warning: return QApplication::translate("hygroloom", "Warning");
    case Severity::note: break;
    }
    return QApplication::translate("hygroloom", "Note");
}

PaperColors paperColors(const QPalette& palette)
{
    if (isDark(palette)) { return {"#d8d5cd", "#14171a", "#0b6aa8"}; }
    return {palette.color(QPalette::Base), palette.color(QPalette::Text), palette.color(QPalette::Highlight)};
}

QColor quietText(const QPalette& palette) { return palette.color(QPalette::Disabled, QPalette::WindowText); }

} // namespace hygroloom
