#include "widgets/style/icons.h"

#include <algorithm>
#include <iterator>

#include <QIconEngine>
#include <QPainter>
#include <QPainterPath>

#include "widgets/style/theme.h"

namespace usar::widgets {

namespace {

/// Paths as text: M x y, L x y, Q cx cy x y, C c1 c2 end, Z, O cx cy r (circle), R x y w h (rectangle).
struct Drawing {
    const char* name;
    const char* fill;
    const char* stroke;
};

constexpr Drawing drawings[] = {
    // Time and map.
    {"play", "M 7 4 L 20 12 L 7 20 Z", ""},
    {"pause", "R 6 5 4 14 R 14 5 4 14", ""},
    {"step", "M 5 5 L 15 12 L 5 19 Z R 16 5 3 14", ""},
    {"back", "M 12 5 L 3 12 L 12 19 Z M 21 5 L 12 12 L 21 19 Z", ""},
    {"forward", "M 3 5 L 12 12 L 3 19 Z M 12 5 L 21 12 L 12 19 Z", ""},
    {"record", "O 12 12 7", ""},
    {"stop", "R 5 5 14 14", ""},
    {"land", "", "M 12 3 L 12 14 M 7 10 L 12 15 L 17 10 M 4 20 L 20 20"},
    {"fit", "", "M 4 9 L 4 4 L 9 4 M 15 4 L 20 4 L 20 9 M 20 15 L 20 20 L 15 20 M 9 20 L 4 20 L 4 15"},
    {"follow", "O 12 12 3", "O 12 12 7 M 12 1 L 12 5 M 12 19 L 12 23 M 1 12 L 5 12 M 19 12 L 23 12"},
    {"plus", "", "M 12 5 L 12 19 M 5 12 L 19 12"},
    {"minus", "", "M 5 12 L 19 12"},
    {"area", "R 2 3 4 4 R 18 3 4 4 R 2 17 4 4 R 18 17 4 4", "M 6 5 L 18 5 M 20 7 L 20 17 M 18 19 L 6 19 M 4 17 L 4 7"},
    {"hand", "",
     "M 12 2 L 12 22 M 2 12 L 22 12 M 9 5 L 12 2 L 15 5 M 9 19 L 12 22 L 15 19 M 5 9 L 2 12 L 5 15 "
     "M 19 9 L 22 12 L 19 15"},
    // The window.
    {"export", "", "M 12 15 L 12 3 M 7 8 L 12 3 L 17 8 M 4 15 L 4 20 L 20 20 L 20 15"},
    {"open", "", "M 3 19 L 3 5 L 9 5 L 11 8 L 20 8 L 20 11 M 3 19 L 7 11 L 23 11 L 19 19 Z"},
    {"edit", "", "M 4 20 L 5 15 L 16 4 L 20 8 L 9 19 Z M 13 7 L 17 11"},
    {"eye", "O 12 12 3", "M 2 12 Q 12 1 22 12 Q 12 23 2 12"},
    {"eye-off", "", "M 2 12 Q 12 1 22 12 Q 12 23 2 12 M 4 21 L 20 3"},
    {"plug", "M 6 8 L 18 8 L 18 12 Q 18 17 12 17 Q 6 17 6 12 Z", "M 9 8 L 9 3 M 15 8 L 15 3 M 12 17 L 12 22"},
    {"unplug", "", "M 6 8 L 18 8 L 18 12 Q 18 17 12 17 Q 6 17 6 12 Z M 9 8 L 9 3 M 15 8 L 15 3 M 12 17 L 12 22"},
    {"sun", "O 12 12 4",
     "M 12 1 L 12 4 M 12 20 L 12 23 M 1 12 L 4 12 M 20 12 L 23 12 M 4 4 L 6 6 M 18 18 L 20 20 "
     "M 4 20 L 6 18 M 18 6 L 20 4"},
    {"moon", "M 15 3 Q 4 4 5 13 Q 7 21 16 21 Q 19 21 21 18 Q 13 19 12 12 Q 11 7 15 3 Z", ""},
    {"robot", "M 12 2 L 20 21 L 12 16 L 4 21 Z", ""},
    {"layers", "", "M 12 3 L 22 9 L 12 15 L 2 9 Z M 2 14 L 12 20 L 22 14"},
    {"plot", "", "M 3 3 L 3 21 L 21 21 M 6 16 L 10 9 L 14 13 L 20 5"},
    {"clear", "", "M 5 5 L 19 19 M 19 5 L 5 19"},
    {"history", "M 1 11 L 8 11 L 4.5 16 Z",
     "M 4.5 11 Q 5 4 12 3.5 Q 20 4 20.5 12 Q 20 20 12 20.5 Q 8 20.5 6 18 M 12 8 L 12 13 L 16 15"},
    {"reset", "M 2 4 L 9 4 L 5.5 11 Z", "M 6 7 Q 11 2 17 6 Q 22 11 18 17 Q 13 22 7 18"},
    {"search", "", "O 10 10 6 M 15 15 L 21 21"},
    {"help", "O 12 19.5 1.5", "M 7.5 8.5 Q 7.5 3.5 12 3.5 Q 16.5 3.5 16.5 8 Q 16.5 10.5 13.5 11.8 Q 12 12.6 12 15"},
    {"message", "", "M 3 4 L 21 4 L 21 16 L 10 16 L 5 21 L 5 16 L 3 16 Z"},
    {"bell", "M 9 20 L 15 20 Q 12 24 9 20 Z", "M 4 18 Q 7 15 7 10 Q 7 4 12 4 Q 17 4 17 10 Q 17 15 20 18 Z"},
    {"settings", "O 9 6 2.5 O 16 12 2.5 O 7 18 2.5", "M 3 6 L 21 6 M 3 12 L 21 12 M 3 18 L 21 18"},
    // Signs and objects.
    {"note", "O 12 7 1.5", "O 12 12 9 M 12 11 L 12 17"},
    {"warning", "O 12 17.3 1.3", "M 12 3 L 22 20.5 L 2 20.5 Z M 12 9 L 12 14"},
    {"error", "",
     "M 8 2.5 L 16 2.5 L 21.5 8 L 21.5 16 L 16 21.5 L 8 21.5 L 2.5 16 L 2.5 8 Z M 8.5 8.5 L 15.5 15.5 "
     "M 15.5 8.5 L 8.5 15.5"},
    {"check", "", "M 4 13 L 10 19 L 20 5"},
    {"box", "", "M 12 3 L 20 7 L 20 17 L 12 21 L 4 17 L 4 7 Z M 4 7 L 12 11 L 20 7 M 12 11 L 12 21"},
    {"crate", "", "R 3 3 18 18 M 3 3 L 21 21 M 21 3 L 3 21"},
    {"brick", "", "R 2 8 20 9 M 2 12.5 L 22 12.5 M 12 8 L 12 12.5 M 7 12.5 L 7 17 M 17 12.5 L 17 17"},
    {"ball", "O 9 9 1.5", "O 12 12 9"},
    {"soccer-ball", "M 12 8 L 16 11 L 14.5 15.5 L 9.5 15.5 L 8 11 Z",
     "O 12 12 9 M 12 8 L 12 3 M 16 11 L 20.5 9.5 M 14.5 15.5 L 17.5 19 M 9.5 15.5 L 6.5 19 M 8 11 L 3.5 9.5"},
    {"barrel", "", "M 6 3 Q 3 12 6 21 L 18 21 Q 21 12 18 3 Z M 5 8 L 19 8 M 5 16 L 19 16"},
    {"cylinder", "",
     "M 5 6 Q 5 3 12 3 Q 19 3 19 6 Q 19 9 12 9 Q 5 9 5 6 M 5 6 L 5 18 Q 5 21 12 21 Q 19 21 19 18 "
     "L 19 6"},
    {"conveyor", "O 6 16 1.5 O 18 16 1.5",
     "M 6 12 L 18 12 Q 22 12 22 16 Q 22 20 18 20 L 6 20 Q 2 20 2 16 Q 2 12 6 12 M 5 6 L 18 6 "
     "M 15 3 L 18 6 L 15 9"},
    // Plans and ways.
    {"turn-left", "M 2 10 L 10 10 L 6 16 Z", "M 6 11 Q 6 4 13 4 Q 20 4 20 11 Q 20 18 13 19"},
    {"turn-right", "M 22 10 L 14 10 L 18 16 Z", "M 18 11 Q 18 4 11 4 Q 4 4 4 11 Q 4 18 11 19"},
    {"spin", "M 17 1 L 23 5 L 16 8 Z M 7 23 L 1 19 L 8 16 Z",
     "M 4 14 Q 3 5 12 4 L 17 4.5 M 20 10 Q 21 19 12 20 L 7 19.5"},
    {"trash", "", "M 4 6 L 20 6 M 9 6 L 9 3 L 15 3 L 15 6 M 6 6 L 7 21 L 17 21 L 18 6 M 10 10 L 10 17 M 14 10 L 14 17"},
    {"undo", "M 2 9 L 9 3 L 9 15 Z", "M 8 9 L 15 9 Q 21 9 21 14 Q 21 19 15 19 L 8 19"},
    {"redo", "M 22 9 L 15 3 L 15 15 Z", "M 16 9 L 9 9 Q 3 9 3 14 Q 3 19 9 19 L 16 19"},
    {"save", "", "M 4 4 L 17 4 L 20 7 L 20 20 L 4 20 Z M 8 4 L 8 9 L 15 9 L 15 4 M 8 20 L 8 14 L 16 14 L 16 20"},
    {"page", "", "M 6 3 L 14 3 L 19 8 L 19 21 L 6 21 Z M 14 3 L 14 8 L 19 8"},
    {"compare", "", "R 3 5 7 14 R 14 5 7 14 M 5 9 L 8 9 M 5 13 L 8 13 M 16 9 L 19 9 M 16 15 L 19 15"},
    {"lamp", "", "O 12 9 6 M 10 15 L 10 19 L 14 19 L 14 15 M 10.5 22 L 13.5 22"},
    {"pieces", "R 3 3 7 7 O 17.5 6.5 3.5 M 3 21 L 6.5 14 L 10 21 Z", "R 14 14 7 7"},
    {"waypoint", "O 5 19 2.5 O 19 5 2.5", "M 6 17 Q 6 11 12 12 Q 18 13 18 7"},
    {"waypoint-off", "O 5 19 2.5 O 19 5 2.5", "M 6 17 Q 6 11 12 12 Q 18 13 18 7 M 3 4 L 21 21"},
    {"trash-all", "",
     "M 3 9 L 15 9 M 6 9 L 6 6 L 12 6 L 12 9 M 4.5 9 L 5.5 21 L 12.5 21 L 13.5 9 M 10 2 L 21 2 M 17 6 L 21 6 "
     "M 18 10 L 21 10 M 17 14 L 20 14 M 16.5 18 L 19.5 18"},
    {"text", "", "M 3 4 L 15 4 M 6 9 L 21 9 M 6 14 L 18 14 M 3 19 L 12 19"},
    {"up", "", "M 5 15 L 12 8 L 19 15"},
    {"down", "", "M 5 9 L 12 16 L 19 9"},
    {"unfold", "", "M 6 8 L 12 2 L 18 8 M 6 16 L 12 22 L 18 16 M 4 12 L 20 12"},
    {"fold", "", "M 6 2 L 12 8 L 18 2 M 6 22 L 12 16 L 18 22 M 4 12 L 20 12"},
    {"branches", "O 4 12 2.5 O 19 4 2.5 O 19 12 2.5 O 19 20 2.5",
     "M 4 12 L 19 12 M 11 12 L 11 4 L 19 4 M 11 12 L 11 20 L 19 20"},
    {"trace", "O 4 19 2 O 9 15 2 O 13 10 2 O 19 6 2", ""}};

/// Parses one of the drawings above. They are the only input, so there is no error handling.
QPainterPath pathOf(const char* text) {
    QPainterPath path;
    const QStringList words = QString::fromLatin1(text).split(u' ', Qt::SkipEmptyParts);
    qsizetype at = 0;
    const auto number = [&] { return at < words.size() ? words[at++].toDouble() : 0.0; };
    const auto point = [&] {
        const double x = number();
        return QPointF(x, number());
    };
    while (at < words.size()) {
        const QString word = words[at++];
        if (word == u"M")
            path.moveTo(point());
        else if (word == u"L")
            path.lineTo(point());
        else if (word == u"Q") {
            const QPointF control = point();
            path.quadTo(control, point());
        } else if (word == u"Z")
            path.closeSubpath();
        else if (word == u"O") {
            const QPointF center = point();
            const double radius = number();
            path.addEllipse(center, radius, radius);
        } else if (word == u"R") {
            const QPointF corner = point();
            const QPointF size = point();
            path.addRect(QRectF(corner, QSizeF(size.x(), size.y())));
        }
    }
    return path;
}

class VectorIconEngine : public QIconEngine {
public:
    VectorIconEngine(Drawing drawing, QColor color) : drawing_(drawing), color_(std::move(color)) {}

    void paint(QPainter* painter, const QRect& rect, QIcon::Mode mode, QIcon::State state) override {
        const Tokens& t = tokens();
        QColor ink = color_.isValid() ? color_ : state == QIcon::On ? t.accent : t.text;
        if (mode == QIcon::Disabled)
            ink = t.stale;
        if (mode == QIcon::Selected)
            ink = inkOn(t.accent);
        const double side = std::min(rect.width(), rect.height());
        painter->save();
        painter->setRenderHint(QPainter::Antialiasing);
        painter->translate(rect.x() + (rect.width() - side) / 2.0, rect.y() + (rect.height() - side) / 2.0);
        painter->scale(side / 24.0, side / 24.0);
        painter->setPen(QPen(ink, 2.0, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
        painter->setBrush(Qt::NoBrush);
        painter->drawPath(pathOf(drawing_.stroke));
        painter->fillPath(pathOf(drawing_.fill), ink);
        painter->restore();
    }
    QPixmap pixmap(const QSize& size, QIcon::Mode mode, QIcon::State state) override {
        QPixmap pixmap(size);
        pixmap.fill(Qt::transparent);
        QPainter painter(&pixmap);
        paint(&painter, QRect(QPoint(), size), mode, state);
        return pixmap;
    }
    QIconEngine* clone() const override { return new VectorIconEngine(*this); }

private:
    Drawing drawing_;
    QColor color_;
};

} // namespace

QIcon icon(const QString& name, const QColor& color) {
    const auto* const found = std::ranges::find(drawings, name, &Drawing::name);
    return found == std::end(drawings) ? QIcon() : QIcon(new VectorIconEngine(*found, color));
}

QStringList iconNames() {
    QStringList names;
    for (const Drawing& drawing : drawings)
        names << drawing.name;
    return names;
}

} // namespace usar::widgets
