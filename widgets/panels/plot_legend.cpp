#include "widgets/panels/plot_legend.h"

#include <algorithm>

#include <QHeaderView>
#include <QPainter>

#include "widgets/models/figures.h"
#include "widgets/models/plot/plot_texts.h"
#include "widgets/panels/plot_pane.h"
#include "widgets/style/form_parts.h"

namespace usar::widgets {

namespace {

constexpr int name_px = 150;
constexpr int value_px = 92;
constexpr int count_px = 56;

QIcon swatch(int index) {
    QPixmap pixmap(16, 16);
    pixmap.fill(Qt::transparent);
    QPainter painter(&pixmap);
    QPen pen(plotLineColor(index, currentTheme()), 4.0, index / 9 % 2 == 0 ? Qt::SolidLine : Qt::DotLine);
    pen.setCapStyle(Qt::FlatCap);
    painter.setPen(pen);
    painter.drawLine(1, 8, 15, 8);
    return pixmap;
}

} // namespace

PlotLegend::PlotLegend(QWidget* parent) : QTreeWidget(parent) {
    setColumnCount(column_count);
    setRootIsDecorated(false);
    setIndentation(0);
    setUniformRowHeights(true);
    setFrameShape(QFrame::NoFrame);
    setTextElideMode(Qt::ElideMiddle);
    setSelectionMode(QAbstractItemView::ExtendedSelection);
    setContextMenuPolicy(Qt::CustomContextMenu);
    setAccessibleName(tr("Plotted values"));
    header()->setStretchLastSection(false);
    header()->setSectionsMovable(false);
    header()->setMinimumSectionSize(40);
    header()->setSectionResizeMode(QHeaderView::Interactive);
    for (int column = Now; column < column_count; ++column)
        header()->resizeSection(column, column == Count ? count_px : value_px);
    connect(addRowAction(this, tr("Remove from the plot"), QKeySequence::Delete), &QAction::triggered, this,
            &PlotLegend::removeRequested);
    connect(this, &QWidget::customContextMenuRequested, this, [this](const QPoint& at) { popUpRowMenu(this, at); });
}

void PlotLegend::rebuild(const PlotModel& model) {
    clear();
    items_.clear();
    rows_ = model.shown();
    const std::size_t canvases = model.layout().canvases.size();
    std::vector<QTreeWidgetItem*> groups(canvases, invisibleRootItem());
    for (std::size_t i = 0; canvases > 1 && i < canvases; ++i) {
        groups[i] = new QTreeWidgetItem(this, {tr("Plot %1").arg(i + 1)});
        groups[i]->setFlags(Qt::ItemIsEnabled);
        groups[i]->setForeground(Name, tokens().text_muted);
        groups[i]->setFirstColumnSpanned(true);
        groups[i]->setSizeHint(Name, QSize(0, minimum_target)); // All rows are as high as the first.
        groups[i]->setExpanded(true);
    }
    for (const ShownSeries& row : rows_) {
        auto* item = new QTreeWidgetItem(groups[row.canvas], {labelOf(row.key)});
        item->setIcon(Name, swatch(row.color));
        item->setToolTip(Name, labelOf(row.key));
        item->setSizeHint(Name, QSize(0, minimum_target));
        for (int column = Now; column < column_count; ++column)
            item->setTextAlignment(column, Qt::AlignRight | Qt::AlignVCenter);
        items_.push_back(item);
    }
    expandAll();
    showColumns(model);
}

void PlotLegend::showColumns(const PlotModel& model) {
    const PlotCursors& cursors = model.cursors();
    const bool both = cursors.difference_s().has_value();
    bool changed = false;
    const auto show = [&](Column column, bool shown) {
        changed = changed || isColumnHidden(column) == shown;
        setColumnHidden(column, !shown);
    };
    show(AtA, cursors.a_s.has_value());
    show(AtB, cursors.b_s.has_value());
    show(Difference, both);
    show(Slope, both);
    for (const Column column : {Count, Least, Most, Mean, Deviation})
        show(column, model.layout().statistics);
    if (!changed)
        return;
    fitName();
    emit columnsChanged();
}

void PlotLegend::showHead(const PlotModel& model, const Times& times) {
    const PlotCursors& cursors = model.cursors();
    const bool between = cursors.difference_s().has_value();
    const QString span = between ? tr("between the cursors") : tr("of the visible span");
    const auto head = [this](Column column, const QString& text, const QString& help) {
        headerItem()->setText(column, text);
        headerItem()->setToolTip(column, help);
        headerItem()->setTextAlignment(column, column == Name ? Qt::AlignLeft : Qt::AlignRight);
    };
    head(Name, tr("Series"), tr("Robot, sensor and field"));
    head(Now, times.mouse_s ? tr("Mouse") : tr("Newest"), tr("The value at the mouse, or the newest one"));
    head(AtA, cursors.a_s ? tr("A %1").arg(momentText(*cursors.a_s)) : QString(), tr("The value at cursor A"));
    head(AtB, cursors.b_s ? tr("B %1").arg(momentText(*cursors.b_s)) : QString(), tr("The value at cursor B"));
    head(Difference, between ? QStringLiteral("Δ ") + differenceText(cursors.difference_s(), "s") : QString(),
         tr("The value at B minus that at A; in the head, the time from A to B"));
    head(Slope, tr("Slope"), tr("The difference divided by the time from A to B"));
    head(Count, QStringLiteral("n"), tr("Number of values %1").arg(span));
    head(Least, tr("Min"), tr("Least value %1").arg(span));
    head(Most, tr("Max"), tr("Greatest value %1").arg(span));
    head(Mean, tr("Mean"), tr("Mean of the values %1").arg(span));
    head(Deviation, QStringLiteral("σ"), tr("Standard deviation of the values %1").arg(span));
}

void PlotLegend::showValues(const PlotModel& model, const Times& times) {
    showColumns(model);
    showHead(model, times);
    const double at_s = std::min(times.mouse_s.value_or(model.shownUntil_s()), model.shownUntil_s());
    for (std::size_t i = 0; i < rows_.size(); ++i) {
        const Series* const series = model.store().find(rows_[i].key);
        if (!series) // The table is about to be rebuilt.
            continue;
        const std::string& unit = series->unit;
        const CursorRow row = cursorRow(series->samples, model.cursors());
        items_[i]->setText(Now, readingText(series->samples.at(at_s), unit));
        items_[i]->setText(AtA, readingText(row.a, unit));
        items_[i]->setText(AtB, readingText(row.b, unit));
        items_[i]->setText(Difference, differenceText(row.difference, unit));
        items_[i]->setText(Slope, differenceText(row.slope_per_s, unit, QStringLiteral("/s")));
        if (!model.layout().statistics)
            continue;
        const std::vector<QString> texts = statisticsTexts(model.statistics(*series, times.from_s, times.to_s), unit);
        for (std::size_t n = 0; n < texts.size(); ++n)
            items_[i]->setText(static_cast<int>(Count + n), texts[n]);
    }
}

std::vector<ShownSeries> PlotLegend::selectedRows() const {
    std::vector<ShownSeries> selected;
    for (std::size_t i = 0; i < items_.size(); ++i)
        if (items_[i]->isSelected())
            selected.push_back(rows_[i]);
    return selected;
}

// Names of robots must not vanish behind figures: the table scrolls sideways before that.
void PlotLegend::fitName() {
    const int figures = wantedWidth() - name_px;
    header()->resizeSection(Name, std::max(name_px, viewport()->width() - figures));
}

void PlotLegend::resizeEvent(QResizeEvent* event) {
    QTreeWidget::resizeEvent(event);
    fitName();
}

int PlotLegend::wantedWidth() const {
    int width = name_px;
    for (int column = Now; column < column_count; ++column)
        width += isColumnHidden(column) ? 0 : columnWidth(column);
    return width;
}

} // namespace usar::widgets
