#include "widgets/bars/connection_bar.h"

#include <algorithm>
#include <chrono>
#include <utility>

#include <QEvent>
#include <QHBoxLayout>

#include "core/protocol/usual_values.h"
#include "widgets/models/figures.h"
#include "widgets/style/icons.h"
#include "widgets/style/theme.h"

namespace usar::widgets {

namespace {

QString retryWords(const ConnectionStatus& status, Seconds retry_in) {
    if (status.state != ConnectionState::Waiting)
        return {};
    return retry_in.count() < 0.5 ? ConnectionBar::tr("Retrying now.")
                                  : ConnectionBar::tr("Retrying in %1 s.").arg(figure(retry_in.count(), 0));
}

QString words(const ConnectionStatus& status) {
    switch (status.state) {
    case ConnectionState::Disconnected:
        return status.reason.isEmpty() ? ConnectionBar::tr("Not connected") : status.reason;
    case ConnectionState::Connecting:
        return ConnectionBar::tr("Connecting…");
    case ConnectionState::Connected:
        return status.where.isEmpty() ? ConnectionBar::tr("Connected")
                                      : ConnectionBar::tr("Connected · %1").arg(status.where);
    case ConnectionState::Waiting:
        break;
    }
    return status.reason;
}

StateShape shape(const ConnectionStatus& status) {
    switch (status.state) {
    case ConnectionState::Disconnected:
        return status.reason.isEmpty() ? StateShape::Off : StateShape::Bad;
    case ConnectionState::Connecting:
        return StateShape::Busy;
    case ConnectionState::Connected:
        return StateShape::Good;
    case ConnectionState::Waiting:
        break;
    }
    return StateShape::Waiting;
}

} // namespace

ConnectionBar::ConnectionBar(QWidget* parent) : QWidget(parent) {
    setAccessibleName(tr("Connection"));
    setUpAddress();
    setUpStatus();
    auto* row = new QHBoxLayout(this);
    row->setContentsMargins(gap::small, gap::tiny, gap::small, gap::tiny);
    row->setSpacing(gap::small);
    for (QWidget* widget : std::initializer_list<QWidget*>{server_, host_, port_, button_, dot_})
        row->addWidget(widget);
    row->addWidget(status_text_, 1);
    row->addWidget(retry_);
    row->addWidget(rate_);
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
    server_->setAccessibleName(tr("Server"));
    server_->setToolTip(tr("The simulator inside this program, or a USARSim server in the network"));
    host_->setAccessibleName(tr("Host"));
    host_->setToolTip(tr("Name or address of the USARSim server"));
    host_->setMinimumWidth(host_->fontMetrics().horizontalAdvance(QStringLiteral("000.000.000")));
    host_->setTextMargins(2, 0, 2, 0); // Same distance to the frame as in the port's box.
    host_->setMaximumWidth(host_->fontMetrics().horizontalAdvance(QStringLiteral("some-long-host.example.org")));
    port_->setRange(1, 65535);
    port_->setValue(protocol::usual_port::bot);
    port_->setButtonSymbols(QAbstractSpinBox::NoButtons);
    port_->setAccessibleName(tr("Port"));
    port_->setToolTip(tr("TCP port of the server; USARSim listens on %1").arg(protocol::usual_port::bot));
    button_->setIcon(icon(QStringLiteral("plug")));
    button_->setText(tr("Disconnect")); // The longest text, so that the neighbors do not move.
    button_width_px_ = button_->sizeHint().width();
    for (QWidget* control : std::initializer_list<QWidget*>{server_, host_, port_, button_})
        control->setMinimumHeight(minimum_target);
}

void ConnectionBar::setUpStatus() {
    status_text_->setAccessibleName(tr("State of the connection"));
    status_text_->setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Preferred);
    status_text_->setRoomFor(QStringLiteral("Connected · point_lookout"));
    status_text_->setMinimumWidth(status_text_->fontMetrics().horizontalAdvance(QStringLiteral("Connected · tall")));
    retry_->setAccessibleName(tr("Next try"));
    retry_->setMinimumWidth(retry_->fontMetrics().horizontalAdvance(tr("Retrying in %1 s.").arg(u"00")));
    rate_->setAccessibleName(tr("Info lines per second"));
    rate_->setToolTip(tr("Info lines received per second of wall time; click for all figures of the link"));
    rate_->setAutoRaise(true);
    rate_->setFocusPolicy(Qt::StrongFocus);
    rate_->setMinimumHeight(minimum_target);
    connect(rate_, &QToolButton::clicked, this, &ConnectionBar::openPanel);
    rate_->setMinimumWidth(rate_->fontMetrics().horizontalAdvance(QStringLiteral("00000 lines/s")));
}

void ConnectionBar::setServer(ServerChoice choice) {
    server_->setCurrentIndex(choice == ServerChoice::Embedded ? 0 : 1);
}

ServerChoice ConnectionBar::server() const {
    return server_->currentIndex() == 0 ? ServerChoice::Embedded : ServerChoice::Real;
}

void ConnectionBar::setAddress(const QString& host, quint16 port) {
    host_->setText(host);
    port_->setValue(port);
}

QString ConnectionBar::host() const {
    return host_->text().trimmed();
}

quint16 ConnectionBar::port() const {
    return static_cast<quint16>(port_->value());
}

void ConnectionBar::setStatus(const ConnectionStatus& status) {
    if (status == status_)
        return;
    status_ = status;
    retry_in_ = status.retry_in;
    if (status.state == ConnectionState::Waiting)
        second_.start();
    else
        second_.stop();
    refresh();
}

void ConnectionBar::countDown() {
    retry_in_ = std::max(Seconds(0.0), retry_in_ - Seconds(1.0));
    showWords();
}

void ConnectionBar::showWords() {
    status_text_->setText(words(status_));
    retry_->setText(retryWords(status_, retry_in_));
    retry_->setVisible(!retry_->text().isEmpty());
    const QString address =
        server() == ServerChoice::Real ? QStringLiteral(" %1:%2").arg(host()).arg(port()) : QString();
    for (QLabel* label : std::initializer_list<QLabel*>{status_text_, retry_})
        label->setToolTip(tr("%1\n%2%3").arg(statusText(), server_->currentText(), address));
}

QString ConnectionBar::statusText() const {
    const QStringList sentences{status_text_->text(), retry_->text()};
    return sentences.join(u' ').trimmed();
}

void ConnectionBar::setRoom(BarRoom room) {
    if (std::exchange(room_, room) != room)
        refresh();
}

void ConnectionBar::setRate(std::optional<double> lines_per_s) {
    rate_->setText(lines_per_s ? tr("%1 lines/s").arg(figure(*lines_per_s, 0, 4)) : QString());
    rate_->setEnabled(lines_per_s.has_value());
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
    server_->setVisible(choice_shown);
    server_->setEnabled(off);
    host_->setVisible(real && choice_shown);
    port_->setVisible(real && choice_shown);
    host_->setEnabled(off);
    port_->setEnabled(off);
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
    QPalette palette = status_text_->palette();
    palette.setColor(QPalette::WindowText, stateColor(shape(status_)));
    status_text_->setPalette(palette);
    retry_->setPalette(palette);
}

void ConnectionBar::changeEvent(QEvent* event) {
    if (event->type() == QEvent::StyleChange)
        refresh();
    QWidget::changeEvent(event);
}

} // namespace usar::widgets
