#include "widgets/bars/link_panel.h"

#include <array>

#include <QGridLayout>
#include <QLocale>

#include "widgets/models/figures.h"
#include "widgets/style/form_parts.h"
#include "widgets/style/theme.h"

namespace usar::widgets {

namespace {

QString counted(std::uint64_t count) {
    return QLocale(QLocale::English).toString(static_cast<qulonglong>(count));
}

QLabel* figureLabel(QWidget* parent) {
    auto* label = new QLabel(parent);
    label->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
    label->setMinimumWidth(label->fontMetrics().horizontalAdvance(QStringLiteral("00,000,000")));
    return label;
}

} // namespace

QString trafficSummary(const protocol::TrafficCounts& counts) {
    return LinkPanel::tr("%1 in · %2 out · %3 unknown · %4 malformed · %5 dropped")
        .arg(counted(counts.lines_in), counted(counts.lines_out), counted(counts.unknown), counted(counts.malformed),
             counted(counts.dropped));
}

QString bytesText(double bytes) {
    static constexpr std::array units = {"B", "kB", "MB", "GB", "TB"};
    std::size_t unit = 0;
    for (; bytes >= 1000.0 && unit + 1 < units.size(); ++unit)
        bytes /= 1000.0;
    return figure(bytes, unit == 0 || bytes >= 100.0 ? 0 : 1) + u' ' + QLatin1String(units[unit]);
}

LinkPanel::LinkPanel(QWidget* parent) : QFrame(parent, Qt::Popup), totals_(row_count), rates_(row_count) {
    setAccessibleName(tr("Link figures"));
    setProperty("role", "card");
    auto* grid = new QGridLayout(this);
    grid->setContentsMargins(gap::medium, gap::small, gap::medium, gap::small);
    grid->setHorizontalSpacing(gap::medium);
    grid->setVerticalSpacing(gap::tiny);
    title_->setProperty("role", "title");
    grid->addWidget(title_, 0, 0);
    const QStringList heads{tr("total"), tr("per second")};
    for (int column = 0; column < heads.size(); ++column) {
        QLabel* head = figureLabel(this);
        head->setText(heads[column]);
        head->setProperty("role", "muted");
        grid->addWidget(head, 0, column + 1);
    }
    addRow(LinesIn, tr("Lines in"), tr("From the server"));
    addRow(LinesOut, tr("Lines out"), tr("Sent to the server, including STEP"));
    addRow(BytesIn, tr("Bytes in"), tr("Including line ends and dropped lines"));
    addRow(BytesOut, tr("Bytes out"), tr("Including line ends"));
    addRow(Unknown, tr("Unknown types"),
           tr("Lines whose type no table knows; they are kept whole, shown and recorded"));
    addRow(Malformed, tr("Malformed"), tr("Lines with errors; what could be read was used"));
    addRow(Dropped, tr("Dropped"), tr("Lines longer than 4 MiB, which were left out"));
    addRow(Replaced, tr("DRIVE replaced"),
           tr("DRIVE commands that a newer one replaced, because a server takes only 20 per second"));
    addRow(NotShown, tr("Not shown"),
           tr("Lines that were read and used, but arrived faster than the lists can take them"));
    grid->addWidget(mutedLabel(tr("Since this connection was made"), this), row_count + 1, 0, 1, 3);
    setFigures({});
    setName({});
}

void LinkPanel::addRow(Row row, const QString& name, const QString& help) {
    auto* grid = static_cast<QGridLayout*>(layout());
    auto* label = new QLabel(name, this);
    totals_[row] = figureLabel(this);
    rates_[row] = figureLabel(this);
    totals_[row]->setAccessibleName(name);
    rates_[row]->setAccessibleName(tr("%1 per second").arg(name));
    int column = 0;
    for (QLabel* cell : {label, totals_[row], rates_[row]}) {
        cell->setToolTip(help);
        grid->addWidget(cell, row + 1, column++);
    }
}

void LinkPanel::setName(const QString& name) {
    title_->setText(name.isEmpty() ? tr("Link") : tr("Link of %1").arg(name));
}

void LinkPanel::setFigures(const LinkFigures& figures) {
    const auto& [counts, rates, not_shown] = figures;
    totals_[LinesIn]->setText(counted(counts.lines_in));
    totals_[LinesOut]->setText(counted(counts.lines_out));
    totals_[BytesIn]->setText(bytesText(static_cast<double>(counts.bytes_in)));
    totals_[BytesOut]->setText(bytesText(static_cast<double>(counts.bytes_out)));
    totals_[Unknown]->setText(counted(counts.unknown));
    totals_[Malformed]->setText(counted(counts.malformed));
    totals_[Dropped]->setText(counted(counts.dropped));
    totals_[Replaced]->setText(counted(counts.drives_replaced));
    totals_[NotShown]->setText(counted(not_shown));
    rates_[LinesIn]->setText(figure(rates.lines_in_per_s, 0));
    rates_[LinesOut]->setText(figure(rates.lines_out_per_s, 0));
    rates_[BytesIn]->setText(bytesText(rates.bytes_in_per_s));
    rates_[BytesOut]->setText(bytesText(rates.bytes_out_per_s));
}

void LinkPanel::openBelow(const QWidget* widget) {
    adjustSize();
    move(widget->mapToGlobal(QPoint(widget->width() - width(), widget->height())));
    show();
}

} // namespace usar::widgets
