#include "widgets/panels/radio_view.h"

#include <algorithm>
#include <cmath>

#include <QPainter>
#include <QStyledItemDelegate>

#include "widgets/models/figures.h"
#include "widgets/style/empty_state.h"
#include "widgets/style/sheet.h"
#include "widgets/style/theme.h"

namespace usar::widgets {

namespace {

constexpr int bars_px = 26;
constexpr int names_px = 132;
constexpr int least_history_px = 48;
// Range of strengths that occur between robots within a world.
constexpr double lowest_dbm = -104.0;
constexpr double highest_dbm = -38.0;

void paintBars(QPainter& painter, const QRect& cell, int count, const QColor& color) {
    painter.setPen(Qt::NoPen);
    for (int i = 0; i < 4; ++i) {
        const int height = 5 + 4 * i;
        painter.setBrush(i < count ? color : tokens().line);
        painter.drawRect(QRect(cell.left() + 7 * i, cell.center().y() + 9 - height, 5, height));
    }
}

double level(const QRectF& area, double dbm) {
    const double part = std::clamp((dbm - lowest_dbm) / (highest_dbm - lowest_dbm), 0.0, 1.0);
    return area.bottom() - part * area.height();
}

/// Draws the history with the newest sample at the right edge, and gaps for unknown samples.
void paintHistory(QPainter& painter, const QRectF& area, const RadioRow& row, const QColor& color) {
    const Tokens& t = tokens();
    painter.fillRect(area, t.background);
    painter.setPen(dashedPen(t.danger, 1.0, {3.0, 3.0}));
    const double cutoff = level(area, radio_cutoff_dbm);
    painter.drawLine(QPointF(area.left(), cutoff), QPointF(area.right(), cutoff));
    const double step = area.width() / static_cast<double>(RadioLinkModel::most_samples - 1);
    const std::size_t count = row.history_dbm.size();
    const auto at = [&](std::size_t i) {
        return QPointF(area.right() - static_cast<double>(count - 1 - i) * step, level(area, row.history_dbm[i]));
    };
    painter.setPen(QPen(color, 1.5));
    for (std::size_t i = 1; i < count; ++i)
        if (!std::isnan(row.history_dbm[i - 1]) && !std::isnan(row.history_dbm[i]))
            painter.drawLine(at(i - 1), at(i));
    if (count > 0 && !std::isnan(row.history_dbm.back())) {
        painter.setPen(QPen(color, 4.0, Qt::SolidLine, Qt::RoundCap));
        painter.drawPoint(at(count - 1) - QPointF(2.0, 0.0));
    }
}

/// Paints a radio link's row: names, quality in a word, bars, dBm, and the history with the threshold. Links of unknown
/// strength are gray.
class RadioDelegate : public QStyledItemDelegate {
public:
    using QStyledItemDelegate::QStyledItemDelegate;

    void paint(QPainter* painter, const QStyleOptionViewItem& option, const QModelIndex& index) const override {
        const RadioRow& row = static_cast<const RadioLinkModel*>(index.model())->row(index.row());
        const RadioQuality quality = radioQuality(row.link.strength_dbm);
        const QColor color = radioColor(quality);
        const Tokens& t = tokens();
        painter->save();
        painter->setRenderHint(QPainter::Antialiasing);
        paintRowGround(*painter, option);
        painter->setPen(t.line);
        painter->drawLine(option.rect.bottomLeft(), option.rect.bottomRight());
        QRect rest = option.rect.adjusted(gap::small, gap::tiny, -gap::small, -gap::tiny);
        QRect names(rest.topLeft(), QSize(names_px, rest.height() / 2));
        painter->setFont(themeFont(FontRole::Body, QFont::DemiBold));
        painter->setPen(t.text);
        paintElided(*painter, names, row.link.a + QStringLiteral(" – ") + row.link.b);
        names.translate(0, rest.height() / 2);
        painter->setFont(themeFont(FontRole::Small));
        painter->setPen(color);
        paintElided(*painter, names, radioWord(quality));
        rest.setLeft(rest.left() + names_px + gap::small);
        paintBars(*painter, rest, radioBars(row.link.strength_dbm), color);
        rest.setLeft(rest.left() + bars_px + gap::small);
        painter->setFont(themeFont());
        const QString widest = figure(-188.8, 1);
        QRect number(rest.topLeft(), QSize(painter->fontMetrics().horizontalAdvance(widest), rest.height()));
        painter->setPen(row.link.strength_dbm ? t.text : t.stale);
        painter->drawText(number, Qt::AlignRight | Qt::AlignVCenter,
                          row.link.strength_dbm ? figure(*row.link.strength_dbm, 1) : QStringLiteral("–"));
        const QString unit = QStringLiteral(" dBm");
        rest.setLeft(number.right() + 1);
        painter->setPen(t.text_muted);
        painter->drawText(rest, Qt::AlignLeft | Qt::AlignVCenter, unit);
        rest.setLeft(rest.left() + painter->fontMetrics().horizontalAdvance(unit) + gap::medium);
        if (rest.width() >= least_history_px)
            paintHistory(*painter, rest, row, color);
        painter->restore();
    }

    QSize sizeHint(const QStyleOptionViewItem&, const QModelIndex&) const override {
        return {260, 2 * QFontMetrics(themeFont()).height() + 2 * gap::tiny};
    }
};

} // namespace

RadioView::RadioView(QWidget* parent) : QWidget(parent) {
    laidOut(new QVBoxLayout(this), {}, 0, {view_, legend_})->setStretchFactor(view_, 1);
    setUpPaintedRows(view_, model_, new RadioDelegate(view_), tr("Radio links"));
    view_->setUniformItemSizes(true);
    legend_->setFont(themeFont(FontRole::Small));
    legend_->setContentsMargins(gap::small, gap::tiny, gap::small, gap::tiny);
    legend_->setWordWrap(true);
    legend_->hide();
    empty_state_ = new EmptyState(view_);
    setSource({});
}

void RadioView::take(const std::vector<RadioLink>& links) {
    model_->take(links);
    empty_state_->setVisible(links.empty());
    legend_->setVisible(!links.empty());
}

void RadioView::setSource(const QString& source) {
    const QString meaning = tr("Each bar: one more wall that the link could pass. Dashed: the cut-off, %1 dBm. Lines: "
                               "the last two minutes.")
                                .arg(figure(radio_cutoff_dbm, 0));
    legend_->setText(source.isEmpty() ? meaning : source + QStringLiteral(". ") + meaning);
}

void RadioView::explainEmptiness(qsizetype radios, const QString& trouble, QAction* remedy) {
    empty_state_->setAction(radios < 2 ? remedy : nullptr);
    if (radios < 2)
        empty_state_->setText(tr("No radio links yet"),
                              radios == 0 ? tr("How well robots hear each other appears here. Spawn two robots, or a "
                                               "robot and a base station.")
                                          : tr("How well robots hear each other appears here. Spawn one more robot, or "
                                               "a base station."));
    else if (trouble.isEmpty())
        empty_state_->setText(tr("Asking the wireless server…"), tr("Its first answers come within seconds."));
    else
        empty_state_->setText(tr("No wireless server"), trouble);
}

} // namespace usar::widgets
