#include "widgets/bars/link_panel.h"

#include <array>

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

LinkPanel::LinkPanel(QWidget* parent) : QFrame(parent, Qt::Popup) {
    setAccessibleName(tr("Link figures"));
    setProperty("role", "card");
    auto* grid = gridOf(this, {gap::medium, gap::small, gap::medium, gap::small}, gap::medium, gap::tiny);
    title_->setProperty("role", "title");
    grid->addWidget(title_, 0, 0);
    const QStringList heads{tr("total"), tr("per second")};
    for (int column = 0; column < heads.size(); ++column) {
        QLabel* head = figureLabel(this);
        head->setText(heads[column]);
        head->setProperty("role", "muted");
        grid->addWidget(head, 0, column + 1);
    }
    const std::array<std::pair<QString, QString>, row_count> rows = {
        {{tr("Lines in"), tr("From the server")},
         {tr("Lines out"), tr("Sent to the server, including STEP")},
         {tr("Bytes in"), tr("Including line ends and dropped lines")},
         {tr("Bytes out"), tr("Including line ends")},
         {tr("Unknown types"), tr("Lines whose type no table knows; they are kept whole, shown and recorded")},
         {tr("Malformed"), tr("Lines with errors; what could be read was used")},
         {tr("Dropped"), tr("Lines longer than 4 MiB, which were left out")},
         {tr("DRIVE replaced"),
          tr("DRIVE commands that a newer one replaced, because a server takes only 20 per second")},
         {tr("Not shown"), tr("Lines that were read and used, but arrived faster than the lists can take them")}}};
    for (std::size_t row = 0; row < row_count; ++row) {
        const auto& [name, help] = rows[row];
        totals_[row] = figureLabel(this);
        rates_[row] = figureLabel(this);
        totals_[row]->setAccessibleName(name);
        rates_[row]->setAccessibleName(tr("%1 per second").arg(name));
        int column = 0;
        for (QLabel* cell : {new QLabel(name, this), totals_[row], rates_[row]}) {
            cell->setToolTip(help);
            grid->addWidget(cell, static_cast<int>(row) + 1, column++);
        }
    }
    grid->addWidget(mutedLabel(tr("Since this connection was made"), this), static_cast<int>(row_count) + 1, 0, 1, 3);
    setFigures({});
    setName({});
}

void LinkPanel::setName(const QString& name) {
    title_->setText(name.isEmpty() ? tr("Link") : tr("Link of %1").arg(name));
}

void LinkPanel::setFigures(const LinkFigures& figures) {
    const auto& [counts, rates, not_shown] = figures;
    // In the order of the rows; only the first four have a rate.
    const QString totals[row_count] = {counted(counts.lines_in),
                                       counted(counts.lines_out),
                                       bytesText(static_cast<double>(counts.bytes_in)),
                                       bytesText(static_cast<double>(counts.bytes_out)),
                                       counted(counts.unknown),
                                       counted(counts.malformed),
                                       counted(counts.dropped),
                                       counted(counts.drives_replaced),
                                       counted(not_shown)};
    const QString per_second[] = {figure(rates.lines_in_per_s, 0), figure(rates.lines_out_per_s, 0),
                                  bytesText(rates.bytes_in_per_s), bytesText(rates.bytes_out_per_s)};
    for (std::size_t row = 0; row < row_count; ++row)
        totals_[row]->setText(totals[row]);
    for (std::size_t row = 0; row < std::size(per_second); ++row)
        rates_[row]->setText(per_second[row]);
}

void LinkPanel::openBelow(const QWidget* widget) {
    adjustSize();
    move(widget->mapToGlobal(QPoint(widget->width() - width(), widget->height())));
    show();
}

} // namespace usar::widgets
