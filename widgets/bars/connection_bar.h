// The bar that always shows the state of the link: which server, whether it is connected, and why not; and its popup
// with the traffic counters: lines, bytes and errors.
#pragma once

#include <array>
#include <optional>

#include <QComboBox>
#include <QFrame>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QSpinBox>
#include <QTimer>
#include <QToolButton>
#include <QWidget>

#include "core/base/clock.h"
#include "core/protocol/traffic_counts.h"
#include "widgets/style/form_parts.h"

namespace usar::widgets {

/// Counters of one connection since it was made. `not_shown` lines were read, but not passed to the views.
struct LinkFigures {
    protocol::TrafficCounts counts;
    protocol::TrafficRates rates;
    std::uint64_t not_shown = 0;
    std::optional<Seconds> round_trip; ///< to the server and back; absent: unknown
};

/// "1,234 in · 56 out · 2 unknown · 1 malformed", or "1,234 in · 56 out · no errors": a line below a list.
QString trafficSummary(const protocol::TrafficCounts& counts);
/// "0.04 ms", "3.2 ms", "140 ms"; a dash for an unknown time.
QString roundTripText(std::optional<Seconds> round_trip);
/// "1.5 MB", "240 B": decimal units, at most four characters for the number.
QString bytesText(double bytes);

/// Table with totals and rates per second; the tooltip of each name explains what is counted. GUI thread.
class LinkPanel : public QFrame {
    Q_OBJECT
public:
    explicit LinkPanel(QWidget* parent = nullptr);

    /// Name of the robot whose connection this is: "R1"; empty: none.
    void setName(const QString& name);
    /// Rates are per second of wall time.
    void setFigures(const LinkFigures& figures);
    /// Opens the popup below that widget; a click elsewhere closes it.
    void openBelow(const QWidget* widget);

private:
    static constexpr std::size_t row_count = 10;

    QLabel* title_ = new QLabel(this);
    std::array<QLabel*, row_count> totals_;
    std::array<QLabel*, row_count> rates_;
};

/// The simulator inside this program, or a USARSim server on the network.
enum class ServerChoice { Embedded, Real };

/// Waiting: the last try failed, and the next one starts automatically.
enum class ConnectionState { Disconnected, Connecting, Connected, Waiting };

/// How much the bar shows. Medium: the choice of server is hidden while it cannot be changed. Narrow: additionally, the
/// button has no text while there is a link.
enum class BarRoom { Wide, Medium, Narrow };

/// State of the link as the bar shows it. `where` is shown when connected ("tall_test"); `reason` is a sentence that
/// includes the remedy.
struct ConnectionStatus {
    ConnectionState state = ConnectionState::Disconnected;
    QString where;         ///< name of the world or server, shown when connected
    QString reason;        ///< without the time to the next try, which the bar appends
    Seconds retry_in{0.0}; ///< while Waiting: wall time to the next try
    QString open_to{};     ///< networks whose programs may connect, too; empty: only this machine's may
    bool operator==(const ConnectionStatus&) const = default;
};

/// Server choice, host and port come in; requests to connect and disconnect go out. It never connects by itself. While
/// waiting, it counts down the seconds to the next try in wall time. GUI thread.
class ConnectionBar : public QWidget {
    Q_OBJECT
public:
    explicit ConnectionBar(QWidget* parent = nullptr);

    /// Emits nothing.
    void setServer(ServerChoice choice) { server_->setCurrentIndex(choice == ServerChoice::Embedded ? 0 : 1); }
    /// The current choice, connected or not.
    ServerChoice server() const { return server_->currentIndex() == 0 ? ServerChoice::Embedded : ServerChoice::Real; }
    /// Host and TCP port of the real server; the embedded one needs none.
    void setAddress(const QString& host, quint16 port);
    /// Host as typed, trimmed; may be empty.
    QString host() const { return host_->text().trimmed(); }
    /// TCP port, 1..65535.
    quint16 port() const { return static_cast<quint16>(port_->value()); }
    /// Shows the state. The server choice is locked unless the state is Disconnected.
    void setStatus(const ConnectionStatus& status);
    /// Sets how much room the bar has; the owner knows the width of the window.
    void setRoom(BarRoom room);
    /// Info lines per second of wall time; nullopt shows no figure. The rate is visible in every BarRoom, the time to
    /// the server and back in a wide bar only.
    void setRate(std::optional<double> lines_per_s, std::optional<Seconds> round_trip = std::nullopt);
    /// "48 lines/s · 0.4 ms"; empty while no rate is known.
    QString rateText() const { return rate_->text(); }
    /// The popup with all figures of the link, which a click on the rate opens. It always exists, so it can be filled
    /// at any time; owned by the bar.
    LinkPanel* panel() const { return panel_; }
    void openPanel() { panel_->openBelow(rate_); }
    /// The complete status text, even if part of it is elided on the screen.
    QString statusText() const { return QString(status_text_->text() + u' ' + retry_->text()).trimmed(); }

signals:
    /// For a real server the host is trimmed and not empty; for the embedded one it is empty and the port is 0.
    void connectRequested(usar::widgets::ServerChoice choice, const QString& host, quint16 port);
    /// Also means "stop trying" while connecting or waiting.
    void disconnectRequested();

private:
    void setUpAddress();
    void setUpStatus();
    void countDown();
    void showWords();
    void showRate();
    /// Connects, disconnects or cancels, depending on the state.
    void press();
    void refresh();

    ConnectionStatus status_; ///< as last set
    BarRoom room_ = BarRoom::Wide;
    int button_width_px_ = 0; ///< width with its longest word
    std::optional<double> lines_per_s_;
    std::optional<Seconds> round_trip_;
    Seconds retry_in_{0.0}; ///< time to the next try, counting down
    QTimer second_{this};
    QComboBox* server_ = new QComboBox(this);
    QLineEdit* host_ = new QLineEdit(QStringLiteral("127.0.0.1"), this);
    QSpinBox* port_ = new QSpinBox(this);
    QPushButton* button_ = new QPushButton(this);
    StateDot* dot_ = new StateDot(this);
    ElidedLabel* status_text_ = new ElidedLabel(this); ///< elided with "…" if there is no room
    QLabel* retry_ = new QLabel(this);                 ///< never elided, because it changes every second
    QToolButton* rate_ = new QToolButton(this);
    LinkPanel* panel_ = new LinkPanel(this);
};

} // namespace usar::widgets
