#include "widgets/bars/connection_bar.h"

#include <algorithm>
#include <chrono>
#include <utility>

#include <QLocale>

#include "core/protocol/usual_values.h"
#include "widgets/models/figures.h"
#include "widgets/style/icons.h"
#include "widgets/style/theme.h"
#include "widgets/style/tips.h"

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

QString retryWords(const ConnectionStatus& status, Seconds retry_in) {
    if (status.state != ConnectionState::Waiting)
        return {};
    return retry_in.count() < 0.5 ? ConnectionBar::tr("Retrying now.")
                                  : ConnectionBar::tr("Retrying in %1 s.").arg(figure(retry_in.count(), 0));
}

QString words(const ConnectionStatus& status) {
    if (status.state == ConnectionState::Connecting)
        return ConnectionBar::tr("Connecting…");
    if (status.state == ConnectionState::Connected) {
        const QString open = status.open_to.isEmpty() ? QString() : ConnectionBar::tr("open to %1").arg(status.open_to);
        QStringList parts{ConnectionBar::tr("Connected"), status.where, open};
        parts.removeAll(QString());
        return parts.join(QStringLiteral(" · "));
    }
    const bool off = status.state == ConnectionState::Disconnected && status.reason.isEmpty();
    return off ? ConnectionBar::tr("Not connected") : status.reason;
}

StateShape shape(const ConnectionStatus& status) {
    if (status.state == ConnectionState::Disconnected && !status.reason.isEmpty())
        return StateShape::Bad;
    constexpr StateShape shapes[] = {StateShape::Off, StateShape::Busy, StateShape::Good, StateShape::Waiting};
    return shapes[static_cast<std::size_t>(status.state)];
}

} // namespace

QString trafficSummary(const protocol::TrafficCounts& counts) {
    QStringList words{LinkPanel::tr("%1 in").arg(counted(counts.lines_in)),
                      LinkPanel::tr("%1 out").arg(counted(counts.lines_out))};
    const qsizetype without_errors = words.size();
    if (counts.unknown > 0)
        words << LinkPanel::tr("%1 unknown").arg(counted(counts.unknown));
    if (counts.malformed > 0)
        words << LinkPanel::tr("%1 malformed").arg(counted(counts.malformed));
    if (counts.dropped > 0)
        words << LinkPanel::tr("%1 dropped").arg(counted(counts.dropped));
    if (words.size() == without_errors)
        words << LinkPanel::tr("no errors");
    return words.join(QStringLiteral(" · "));
}

QString roundTripText(std::optional<Seconds> round_trip) {
    if (!round_trip)
        return LinkPanel::tr("–");
    const double ms = round_trip->count() * 1000.0;
    return LinkPanel::tr("%1 ms").arg(figure(ms, ms < 1.0 ? 2 : ms < 10.0 ? 1 : 0));
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
         {tr("Not shown"), tr("Lines that were read and used, but arrived faster than the lists can take them")},
         {tr("Round trip"), tr("Time to the server and back, as the network's acknowledgments tell it")}}};
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
    const auto& [counts, rates, not_shown, round_trip] = figures;
    // In the order of the rows; only the first four have a rate.
    const QString totals[row_count] = {counted(counts.lines_in),
                                       counted(counts.lines_out),
                                       bytesText(static_cast<double>(counts.bytes_in)),
                                       bytesText(static_cast<double>(counts.bytes_out)),
                                       counted(counts.unknown),
                                       counted(counts.malformed),
                                       counted(counts.dropped),
                                       counted(counts.drives_replaced),
                                       counted(not_shown),
                                       roundTripText(round_trip)};
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

ConnectionBar::ConnectionBar(QWidget* parent) : QWidget(parent) {
    setAccessibleName(tr("Connection"));
    setUpAddress();
    setUpStatus();
    laidOut(new QHBoxLayout(this), {gap::small, gap::tiny, gap::small, gap::tiny}, gap::small,
            {server_, host_, port_, button_, dot_, status_text_, retry_, rate_})
        ->setStretchFactor(status_text_, 1);
    connect(button_, &QPushButton::clicked, this, &ConnectionBar::press);
    connect(host_, &QLineEdit::returnPressed, this, &ConnectionBar::press);
    connect(server_, &QComboBox::currentIndexChanged, this, &ConnectionBar::refresh);
    second_.setInterval(std::chrono::seconds(1));
    connect(&second_, &QTimer::timeout, this, &ConnectionBar::countDown);
    setRate(std::nullopt);
    refresh();
}

void ConnectionBar::setUpAddress() {
    server_->addItem(icon(QStringLiteral("robot")), tr("Embedded simulator"));
    server_->addItem(icon(QStringLiteral("plug")), tr("Real server"));
    named(server_, tr("Server"), tr("The simulator inside this program, or a USARSim server on the network"));
    named(host_, tr("Host"), tr("Name or address of the USARSim server"));
    host_->setMinimumWidth(host_->fontMetrics().horizontalAdvance(QStringLiteral("000.000.000")));
    host_->setTextMargins(2, 0, 2, 0); // Same distance to the frame as in the port's box.
    host_->setMaximumWidth(host_->fontMetrics().horizontalAdvance(QStringLiteral("some-long-host.example.org")));
    port_->setRange(1, 65535);
    port_->setValue(protocol::usual_port::bot);
    port_->setButtonSymbols(QAbstractSpinBox::NoButtons);
    port_->setAccessibleName(tr("Port"));
    tellRange(port_, tr("TCP port of the server; USARSim listens on %1").arg(protocol::usual_port::bot));
    button_->setIcon(icon(QStringLiteral("plug")));
    button_->setText(tr("Disconnect")); // The longest text, so that the neighbors do not move.
    button_width_px_ = button_->sizeHint().width();
    for (QWidget* control : std::initializer_list<QWidget*>{server_, host_, port_, button_})
        control->setMinimumHeight(minimum_target);
}

void ConnectionBar::setUpStatus() {
    status_text_->setAccessibleName(tr("State of the connection"));
    status_text_->setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Preferred);
    status_text_->setMinimumWidth(status_text_->fontMetrics().horizontalAdvance(QStringLiteral("Connected · tall")));
    retry_->setAccessibleName(tr("Next try"));
    retry_->setMinimumWidth(retry_->fontMetrics().horizontalAdvance(tr("Retrying in %1 s.").arg(u"00")));
    named(rate_, tr("Info lines per second"),
          tr("Info lines received per second of wall time, and the time to the server and back; click to see all "
             "figures of the link"));
    rate_->setAutoRaise(true);
    rate_->setFocusPolicy(Qt::StrongFocus);
    rate_->setMinimumHeight(minimum_target);
    connect(rate_, &QToolButton::clicked, this, &ConnectionBar::openPanel);
}

void ConnectionBar::setAddress(const QString& host, quint16 port) {
    host_->setText(host);
    port_->setValue(port);
}

void ConnectionBar::setStatus(const ConnectionStatus& status) {
    if (status == status_)
        return;
    status_ = status;
    retry_in_ = status.retry_in;
    second_.stop();
    if (status.state == ConnectionState::Waiting)
        second_.start();
    refresh();
}

void ConnectionBar::countDown() {
    retry_in_ = std::max(Seconds(0.0), retry_in_ - Seconds(1.0));
    showWords();
}

void ConnectionBar::showWords() {
    status_text_->setText(words(status_));
    // A reason, and who else may connect, have all the room there is; other words always ask for the same, so that
    // their neighbors do not move.
    const bool reasoned = status_text_->text() == status_.reason && !status_.reason.isEmpty();
    status_text_->setRoomFor(reasoned || !status_.open_to.isEmpty() ? status_text_->text()
                                                                    : QStringLiteral("Connected · point_lookout"));
    retry_->setText(retryWords(status_, retry_in_));
    retry_->setVisible(!retry_->text().isEmpty());
    const QString address =
        server() == ServerChoice::Real ? QStringLiteral(" %1:%2").arg(host()).arg(port()) : QString();
    for (QLabel* label : std::initializer_list<QLabel*>{status_text_, retry_})
        label->setToolTip(tr("%1\n%2%3").arg(statusText(), server_->currentText(), address));
}

void ConnectionBar::setRoom(BarRoom room) {
    if (std::exchange(room_, room) != room)
        refresh();
}

void ConnectionBar::setRate(std::optional<double> lines_per_s, std::optional<Seconds> round_trip) {
    lines_per_s_ = lines_per_s;
    round_trip_ = round_trip;
    showRate();
}

/// The button is always as wide as its longest text, so that its neighbors do not move.
void ConnectionBar::showRate() {
    const bool timed = room_ == BarRoom::Wide;
    const QString rate = lines_per_s_ ? tr("%1 lines/s").arg(figure(*lines_per_s_, 0, 4)) : QString();
    const QString time = lines_per_s_ && timed ? QStringLiteral(" · ") + roundTripText(round_trip_) : QString();
    rate_->setText(rate + time);
    rate_->setEnabled(lines_per_s_.has_value());
    const QString longest =
        QStringLiteral("00000 lines/s") + (lines_per_s_ && timed ? QStringLiteral(" · 0.00 ms") : QString());
    rate_->setMinimumWidth(rate_->fontMetrics().horizontalAdvance(longest));
}

void ConnectionBar::press() {
    if (status_.state != ConnectionState::Disconnected)
        emit disconnectRequested();
    else if (server() == ServerChoice::Embedded)
        emit connectRequested(ServerChoice::Embedded, {}, 0); // The typed address belongs to the real server.
    else if (!host().isEmpty())
        emit connectRequested(ServerChoice::Real, host(), port());
}

void ConnectionBar::refresh() {
    const bool off = status_.state == ConnectionState::Disconnected;
    const bool real = server() == ServerChoice::Real;
    const bool choice_shown = off || room_ == BarRoom::Wide;
    for (QWidget* part : std::initializer_list<QWidget*>{server_, host_, port_}) {
        part->setVisible(choice_shown && (real || part == server_));
        part->setEnabled(off);
    }
    const QString word = off                                           ? tr("Connect")
                         : status_.state == ConnectionState::Connected ? tr("Disconnect")
                                                                       : tr("Cancel");
    const bool wordless = room_ == BarRoom::Narrow && !off;
    button_->setText(wordless ? QString() : word);
    button_->setAccessibleName(word);
    button_->setMinimumWidth(room_ == BarRoom::Narrow ? minimum_target : button_width_px_);
    button_->setIcon(icon(off ? QStringLiteral("plug") : QStringLiteral("unplug")));
    button_->setToolTip(off ? tr("Connects, and reconnects by itself when the link breaks")
                            : tr("Closes the link; what was scanned is kept"));
    dot_->setState(shape(status_));
    showWords();
    showRate();
    for (QLabel* label : std::initializer_list<QLabel*>{status_text_, retry_})
        setRole(label, stateRole(shape(status_)));
}

} // namespace usar::widgets
