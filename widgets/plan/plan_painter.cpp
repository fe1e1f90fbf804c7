#include "widgets/plan/plan_painter.h"

#include <array>
#include <cmath>
#include <numbers>

#include <QFontInfo>
#include <QFontMetricsF>
#include <QObject>
#include <QPolygonF>

namespace usar::widgets {

namespace {

constexpr double corner_px = 5.0;
constexpr double full_scale = 0.55;
constexpr double names_scale = 0.14;
constexpr double readable_px = 5.5; ///< letters smaller than this are not drawn
const Seconds fresh(1.5);           ///< older answers belong to another situation and get the stale color

QColor mixed(const QColor& from, const QColor& to, double share) {
    const auto part = [share](int a, int b) { return static_cast<int>(std::lround(a + (b - a) * share)); };
    return QColor(part(from.red(), to.red()), part(from.green(), to.green()), part(from.blue(), to.blue()));
}

/// Returns the font in pixels at a scale of 1, so that screen and paper agree; `bold` for titles.
QFont planFont(bool bold = false) {
    QFont font = themeFont(FontRole::Body, bold ? QFont::DemiBold : QFont::Normal);
    font.setPixelSize(QFontInfo(themeFont()).pixelSize());
    return font;
}

/// Returns "1234", "12k", "3M": at most four characters.
QString shortCount(std::uint64_t count) {
    return count < 10'000          ? QString::number(count)
           : count < 1'000'000     ? QString::number(count / 1000) + u'k'
           : count < 1'000'000'000 ? QString::number(count / 1'000'000) + u'M'
                                   : QStringLiteral("1G+");
}

} // namespace

PlanDetail planDetailAt(double scale) {
    return scale >= full_scale ? PlanDetail::Full : scale >= names_scale ? PlanDetail::Names : PlanDetail::Blocks;
}

PlanMetrics planMetrics() {
    const QFontMetricsF names(planFont(true));
    const QFontMetricsF texts(planFont());
    return {[names](const QString& text) { return names.horizontalAdvance(text); },
            [texts](const QString& text) { return texts.horizontalAdvance(text); }, std::ceil(texts.height()) + 4.0};
}

PlanPainter::PlanPainter(QPainter& painter, const PlanScene& scene, double scale)
    : painter_(painter)
    , scene_(scene)
    , colors_(scene.colors)
    , scale_(scale)
    , detail_(planDetailAt(scale))
    , name_font_(planFont(true))
    , text_font_(planFont()) {}

void PlanPainter::paint(const QRectF& area) {
    painter_.setRenderHint(QPainter::Antialiasing, detail_ == PlanDetail::Full);
    std::vector<PlanNodeId> nodes = scene_.layout.nodesIn(scene_.tree, area);
    paintLines(nodes, area);
    std::erase_if(nodes, [&](PlanNodeId node) { return !boxOf(node).intersects(area); });
    for (const PlanNodeId node : nodes) {
        paintEquals(node);
        paintCard(node);
    }
    for (const PlanNodeId node : nodes) {
        paintMarks(node);
        paintFrames(node);
    }
}

/// Draws one trunk per parent, however many children it has; lines to running nodes are drawn on top.
void PlanPainter::paintLines(const std::vector<PlanNodeId>& nodes, const QRectF& area) {
    std::vector<QLineF> lines;
    std::vector<PlanNodeId> running;
    for (const PlanNodeId node : nodes) {
        if (const auto children = scene_.tree.children(node);
            !children.empty() && scene_.layout.shown(children.back())) {
            const QPointF from = scene_.layout.exit(node);
            const QPointF first = scene_.layout.entry(children.front());
            const double x = trunkOf(from, first);
            const double bottom = std::min(scene_.layout.entry(children.back()).y(), area.bottom());
            lines.emplace_back(x, std::max(from.y(), area.top()), x, bottom);
            if (scene_.layout.flow() == PlanFlow::Across)
                lines.emplace_back(from, QPointF(x, from.y()));
            if (scene_.states[node].running) // The line to a running child outside the area may cross it.
                std::ranges::copy_if(children, std::back_inserter(running),
                                     [this](PlanNodeId child) { return scene_.states[child].running; });
        }
        if (const PlanNodeId parent = scene_.tree[node].parent; parent.valid()) {
            const QPointF from = scene_.layout.exit(parent);
            const QPointF to = scene_.layout.entry(node);
            lines.emplace_back(trunkOf(from, to), to.y(), to.x(), to.y());
        }
    }
    painter_.setPen(QPen(colors_.line, thin()));
    painter_.drawLines(lines.data(), static_cast<int>(lines.size()));
    painter_.setPen(QPen(colors_.accent, std::max(2.5, 2.0 * thin()), Qt::SolidLine, Qt::FlatCap, Qt::MiterJoin));
    for (const PlanNodeId node : running) {
        const QPointF from = scene_.layout.exit(scene_.tree[node].parent);
        const QPointF to = scene_.layout.entry(node);
        const double x = trunkOf(from, to);
        painter_.drawPolyline(QPolygonF({from, {x, from.y()}, {x, to.y()}, to}));
    }
}

double PlanPainter::trunkOf(const QPointF& from, const QPointF& to) const {
    return scene_.layout.flow() == PlanFlow::Across ? (from.x() + to.x()) / 2.0 : from.x();
}

/// Paints a bar beside the members of one level, which have equal priority.
void PlanPainter::paintEquals(PlanNodeId node) {
    if (!scene_.tree[node].has_equals)
        return;
    const QRectF box = boxOf(node);
    const PlanNodeId next = scene_.tree[node].end;
    const bool goes_on = scene_.tree.contains(next) && scene_.tree[next].parent == scene_.tree[node].parent &&
                         scene_.tree[next].level == scene_.tree[node].level;
    const double bottom = goes_on ? boxOf(next).top() : box.bottom();
    painter_.fillRect(QRectF(box.left() - 6.0, box.top(), std::max(3.0, thin()), bottom - box.top()),
                      colors_.text_muted);
}

QColor PlanPainter::fillOf(PlanNodeId node) const {
    const double glow = scene_.states.recency(node);
    const QColor ground = scene_.tree[node].kind == PlanNodeKind::Act || scene_.tree[node].kind == PlanNodeKind::Sense
                              ? colors_.surface
                              : colors_.raised;
    return mixed(node == scene_.hot ? mixed(ground, colors_.text, 0.06) : ground, colors_.accent, 0.38 * glow);
}

void PlanPainter::paintCard(PlanNodeId node) {
    const QRectF box = boxOf(node);
    const double glow = scene_.states.recency(node);
    const bool running = scene_.states[node].running;
    if (detail_ == PlanDetail::Full) {
        painter_.setPen(QPen(mixed(colors_.line, colors_.accent, glow), running ? 2.0 : 1.0,
                             scene_.tree[node].link.valid() ? Qt::DashLine : Qt::SolidLine));
        painter_.setBrush(fillOf(node));
        painter_.drawRoundedRect(box, corner_px, corner_px);
    } else {
        painter_.fillRect(box, mixed(colors_.line, colors_.accent, glow));
        painter_.fillRect(box.adjusted(thin(), thin(), -thin(), -thin()), fillOf(node));
    }
    if (running) // Not only a color: a bar at the left that only running cards have.
        painter_.fillRect(QRectF(box.left(), box.top() + 2.0, std::max(4.0, 2.0 * thin()), box.height() - 4.0),
                          colors_.accent);
    if (detail_ == PlanDetail::Names)
        paintBlockName(node, box);
    if (detail_ != PlanDetail::Full)
        return;
    const double row_px = (box.height() - plan_card::padding_px) / (1 + scene_.tree[node].senses);
    paintTitle(node, {box.left(), box.top() + plan_card::padding_px / 2.0, box.width(), row_px});
    for (const PlanNodeId sense : scene_.tree.senses(node))
        paintSenseRow(sense);
}

/// Uses a font as large as the block allows; blocks of the same height have the same size if their names fit.
void PlanPainter::paintBlockName(PlanNodeId node, const QRectF& box) {
    const QString& name = scene_.tree[node].name;
    const double fitting_px = box.width() * 1.7 / std::max(1.0, double(name.size()));
    const double size_px = std::min({box.height() * 0.7, 30.0, fitting_px});
    if (size_px * scale_ < readable_px)
        return;
    QFont font = text_font_;
    font.setPixelSize(std::max(1, static_cast<int>(size_px)));
    painter_.setFont(font);
    painter_.setPen(colors_.text);
    painter_.drawText(QPointF(box.left() + 5.0, box.center().y() + 0.36 * size_px), name);
}

void PlanPainter::paintTitle(PlanNodeId node, const QRectF& row) {
    using namespace plan_card;
    const PlanNode& what = scene_.tree[node];
    paintKindMark(node, {row.left() + padding_px, row.top(), glyph_px, row.height()});
    double right = paintFoldMark(node, row, row.right() - padding_px);
    right = what.kind == PlanNodeKind::Sense ? paintAnswer(node, row) : paintCounters(node, row, right);
    const double left = row.left() + padding_px + glyph_px;
    paintNameAndDetail(what, name_font_, {left, row.top(), right - left, row.height()}, padding_px, 16.0);
}

/// Paints the name, and the rest of its line after a gap if that has more room than `least_px`.
void PlanPainter::paintNameAndDetail(const PlanNode& what, const QFont& name_font, const QRectF& room, double gap_px,
                                     double least_px) {
    painter_.setFont(name_font);
    const double name_px = QFontMetricsF(name_font).horizontalAdvance(what.name);
    QRectF place = room;
    place.setWidth(std::min(name_px + 1.0, room.width()));
    text(place, what.name, colors_.text);
    place = QRectF(place.right() + gap_px, room.top(), room.right() - place.right() - gap_px, room.height());
    painter_.setFont(text_font_);
    if (!what.detail.isEmpty() && place.width() > least_px)
        text(place, what.detail, colors_.text_muted);
}

/// Paints the priority in a circle for drives (filled) and elements (hollow), and a letter for other kinds.
void PlanPainter::paintKindMark(PlanNodeId node, const QRectF& place) {
    const PlanNode& what = scene_.tree[node];
    const QPointF middle(place.left() + 7.0, place.center().y());
    const QRectF round(middle - QPointF(8.0, 8.0), QSizeF(16.0, 16.0));
    painter_.setPen(QPen(colors_.text_muted, 1.2));
    painter_.setBrush(Qt::NoBrush);
    QString letters;
    QColor ink = colors_.text_muted;
    switch (what.kind) {
    case PlanNodeKind::Drive:
        painter_.setBrush(colors_.text_muted);
        ink = inkOn(colors_.text_muted);
        [[fallthrough]];
    case PlanNodeKind::Element:
        painter_.drawEllipse(round);
        letters = QString::number(what.level + 1);
        break;
    case PlanNodeKind::Act:
        painter_.drawPolygon(QPolygonF({middle + QPointF(-4, -5), middle + QPointF(5, 0), middle + QPointF(-4, 5)}));
        return;
    case PlanNodeKind::Sense:
        return paintVerdict(node, place);
    default:
        constexpr std::array of_form{"P", "DC", "", "C", "", "AP", "AD"}; // In the order of the kinds.
        painter_.drawRoundedRect(round.adjusted(-1.0, 0.5, 1.0, -0.5), 3.0, 3.0);
        letters = QString::fromLatin1(of_form[static_cast<std::size_t>(what.kind)]);
    }
    QFont font = text_font_;
    font.setPixelSize(letters.size() > 2 ? 8 : letters.size() > 1 ? 9 : 11);
    painter_.setFont(font);
    text(round.adjusted(-4.0, 0.0, 4.0, 0.0), letters, ink, Qt::AlignHCenter);
}

/// Paints the counters; returns the right edge of the room for the name.
double PlanPainter::paintCounters(PlanNodeId node, const QRectF& row, double right) {
    const PlanActivity& state = scene_.states[node];
    if (scene_.tree[node].kind == PlanNodeKind::Plan)
        return right;
    const double left = right - plan_card::counters_px;
    if (state.started == 0 && state.failed == 0)
        return left;
    painter_.setFont(text_font_);
    if (state.failed > 0) {
        const QString count = shortCount(state.failed);
        const double width = QFontMetricsF(text_font_).horizontalAdvance(count) + 12.0;
        const QRectF place(right - width, row.top(), width, row.height());
        const double y = row.center().y();
        painter_.setPen(QPen(colors_.danger, 1.6));
        painter_.drawLine(QPointF(place.left() + 2, y - 3), QPointF(place.left() + 8, y + 3));
        painter_.drawLine(QPointF(place.left() + 2, y + 3), QPointF(place.left() + 8, y - 3));
        text(place, count, colors_.danger, Qt::AlignRight);
        right -= width + 4.0;
    }
    text({left, row.top(), right - left, row.height()}, QStringLiteral("×") + shortCount(state.started),
         colors_.text_muted, Qt::AlignRight);
    return left;
}

/// Paints a chevron, the number of folded parts, or the arrow of a link; returns the right edge of the room before it.
double PlanPainter::paintFoldMark(PlanNodeId node, const QRectF& row, double right) {
    const PlanNode& what = scene_.tree[node];
    if (scene_.tree.children(node).empty() && !what.link.valid())
        return right;
    const double y = row.center().y();
    painter_.setPen(QPen(colors_.text_muted, 1.6));
    painter_.setBrush(Qt::NoBrush);
    if (what.link.valid()) {
        painter_.drawLine(QPointF(right - 9.0, y + 4.0), QPointF(right - 1.0, y - 4.0));
        painter_.drawPolyline(QPolygonF({{right - 7.0, y - 4.0}, {right - 1.0, y - 4.0}, {right - 1.0, y + 2.0}}));
    } else if (scene_.folds.folded(scene_.tree, node)) {
        painter_.setFont(text_font_);
        text({right - plan_card::fold_px, row.top(), plan_card::fold_px, row.height()},
             u'+' + shortCount(static_cast<std::uint64_t>(scene_.tree.countBelow(node))), colors_.accent,
             Qt::AlignRight);
    } else {
        painter_.drawPolyline(QPolygonF({{right - 10.0, y - 2.0}, {right - 6.0, y + 2.0}, {right - 2.0, y - 2.0}}));
    }
    return right - plan_card::fold_px;
}

void PlanPainter::paintSenseRow(PlanNodeId sense) {
    using namespace plan_card;
    const PlanNode& what = scene_.tree[sense];
    const QRectF row = boxOf(sense);
    if (sense == scene_.hot)
        painter_.fillRect(row.adjusted(2.0, 0.0, -2.0, 0.0), mixed(fillOf(what.parent), colors_.text, 0.08));
    paintVerdict(sense, {row.left() + padding_px, row.top(), glyph_px, row.height()});
    const double right = paintAnswer(sense, row);
    double left = row.left() + padding_px + glyph_px;
    if (what.of_goal) {
        painter_.setFont(text_font_);
        text({left, row.top(), goal_px, row.height()}, QObject::tr("goal"), colors_.text_muted);
        left += goal_px;
    }
    paintNameAndDetail(what, text_font_, {left, row.top(), right - left, row.height()}, 5.0, 8.0);
}

/// Paints the answer right-aligned, bold if it holds; returns the right edge of the room before it.
double PlanPainter::paintAnswer(PlanNodeId sense, const QRectF& row) {
    const PlanActivity& state = scene_.states[sense];
    const double right = row.right() - plan_card::padding_px;
    const double left = right - plan_card::answer_px;
    if (!state.answer)
        return left;
    const bool old = scene_.states.now() - state.answer->asked > fresh;
    painter_.setFont(state.answer->holds ? name_font_ : text_font_);
    text({left, row.top(), right - left, row.height()}, state.answer->value,
         old                   ? colors_.stale
         : state.answer->holds ? colors_.text
                               : colors_.text_muted,
         Qt::AlignRight);
    return left - 4.0;
}

/// Paints a filled circle with a check (holds), a hollow one with a bar (does not hold), or a small dot (not asked
/// yet).
void PlanPainter::paintVerdict(PlanNodeId sense, const QRectF& place) {
    const auto& answer = scene_.states[sense].answer;
    const QPointF middle(place.left() + 7.0, place.center().y());
    painter_.setPen(Qt::NoPen);
    if (!answer) {
        painter_.setBrush(colors_.text_muted);
        painter_.drawEllipse(middle, 1.8, 1.8);
        return;
    }
    const bool old = scene_.states.now() - answer->asked > fresh;
    if (answer->holds) {
        const QColor fill = old ? colors_.stale : colors_.ok;
        painter_.setBrush(fill);
        painter_.drawEllipse(middle, 6.5, 6.5);
        painter_.setPen(QPen(inkOn(fill), 1.8));
        const QPointF check[] = {middle + QPointF(-3, 0), middle + QPointF(-0.8, 2.6), middle + QPointF(3.2, -2.6)};
        painter_.drawPolyline(check, 3);
    } else {
        painter_.setPen(QPen(old ? colors_.stale : colors_.text_muted, 1.5));
        painter_.setBrush(Qt::NoBrush);
        painter_.drawEllipse(middle, 5.8, 5.8);
        painter_.drawLine(middle + QPointF(-2.8, 0.0), middle + QPointF(2.8, 0.0));
    }
}

/// Paints the frames of search matches and of the selection, above all cards.
void PlanPainter::paintFrames(PlanNodeId node) {
    for (const PlanNodeId what : scene_.tree.rows(node)) {
        if (!scene_.found.empty() && scene_.found[what.index()])
            frame(boxOf(what), colors_.caution, Qt::DotLine);
        if (what == scene_.selected)
            frame(boxOf(what), scene_.focused ? colors_.text : colors_.text_muted, Qt::SolidLine);
    }
}

/// Paints marks on the edges of a card, where nothing else is drawn.
void PlanPainter::paintMarks(PlanNodeId node) {
    if (!scene_.marks || scene_.marks->empty())
        return;
    painter_.setRenderHint(QPainter::Antialiasing);
    for (const PlanNodeId what : scene_.tree.rows(node)) {
        const PlanMark* const mark = scene_.marks->at(what);
        if (!mark)
            continue;
        const bool rows = detail_ == PlanDetail::Full;
        const QRectF box = boxOf(rows ? what : node);
        const double title_px = (box.height() - plan_card::padding_px) / (1 + scene_.tree[what].senses);
        const double y = rows && what == node ? box.top() + (plan_card::padding_px + title_px) / 2.0 : box.center().y();
        if (mark->switched_off)
            paintOff(box);
        if (mark->pinned)
            paintPin({box.right(), y});
        if (mark->breakpoints + mark->breakpoints_off > 0)
            paintBreakpoint(*mark, {box.left() - 4.0 * markSize(), y});
        if (mark->halted)
            paintStand({box.left() - 20.0 * markSize(), y});
    }
    painter_.setRenderHint(QPainter::Antialiasing, detail_ == PlanDetail::Full);
}

/// Paints a stop sign; hollow if disabled, with a bar if it does not always stop.
void PlanPainter::paintBreakpoint(const PlanMark& mark, const QPointF& middle) {
    const double radius = 7.5 * markSize();
    QPolygonF octagon;
    for (int corner = 0; corner < 8; ++corner) {
        const double angle_rad = (corner + 0.5) * std::numbers::pi / 4.0;
        octagon << middle + radius * QPointF(std::cos(angle_rad), std::sin(angle_rad));
    }
    const bool on = mark.breakpoints > 0;
    painter_.setPen(QPen(on ? colors_.background : colors_.danger, 1.5 * markSize()));
    painter_.setBrush(on ? colors_.danger : colors_.background);
    painter_.drawPolygon(octagon);
    if (!mark.conditional)
        return;
    painter_.setPen(QPen(on ? inkOn(colors_.danger) : colors_.danger, 1.8 * markSize()));
    painter_.drawLine(middle - QPointF(radius / 2.0, 0.0), middle + QPointF(radius / 2.0, 0.0));
}

/// Paints an arrow at the part that the plan is halted before.
void PlanPainter::paintStand(const QPointF& middle) {
    const double size = markSize();
    QPolygonF arrow({{-7, -3}, {0, -3}, {0, -7}, {8, 0}, {0, 7}, {0, 3}, {-7, 3}});
    for (QPointF& corner : arrow)
        corner = middle + size * corner;
    painter_.setPen(QPen(colors_.background, 1.2 * size));
    painter_.setBrush(colors_.caution);
    painter_.drawPolygon(arrow);
}

/// Paints a pin with its head.
void PlanPainter::paintPin(const QPointF& middle) {
    const double size = markSize();
    painter_.setPen(QPen(colors_.text, 2.0 * size));
    painter_.drawLine(middle, middle + size * QPointF(-7, 7));
    painter_.setPen(QPen(colors_.background, 1.2 * size));
    painter_.setBrush(colors_.accent);
    painter_.drawEllipse(middle, 5.0 * size, 5.0 * size);
}

/// Paints a veil and a strike-out.
void PlanPainter::paintOff(const QRectF& box) {
    QColor veil = colors_.background;
    veil.setAlphaF(0.6F);
    painter_.fillRect(box, veil);
    painter_.setPen(QPen(colors_.danger, std::max(2.0, 2.0 * thin())));
    painter_.drawLine(box.bottomLeft(), box.topRight());
}

void PlanPainter::frame(const QRectF& box, const QColor& color, Qt::PenStyle style) {
    painter_.setPen(QPen(color, std::max(2.0, 2.0 * thin()), style));
    painter_.setBrush(Qt::NoBrush);
    painter_.drawRoundedRect(box.adjusted(-1.0, -1.0, 1.0, 1.0), corner_px, corner_px);
}

/// Paints one line of text, elided if it does not fit. Aligned by hand, because QPainter's alignment takes as long as
/// the text itself.
void PlanPainter::text(const QRectF& place, const QString& words, const QColor& color, Qt::Alignment align) {
    const QFontMetricsF metrics(painter_.font());
    QString shown = words;
    double width = metrics.horizontalAdvance(words);
    if (width > place.width() + 0.5) {
        shown = metrics.elidedText(words, Qt::ElideRight, place.width());
        width = metrics.horizontalAdvance(shown);
    }
    const double room = place.width() - width;
    const double x = place.left() + (align & Qt::AlignRight ? room : align & Qt::AlignHCenter ? room / 2.0 : 0.0);
    painter_.setPen(color);
    painter_.drawText(QPointF(x, place.center().y() + (metrics.ascent() - metrics.descent()) / 2.0), shown);
}

} // namespace usar::widgets
