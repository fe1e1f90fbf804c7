// Truth about the link, always in sight: which server, how it stands, why not.
#pragma once

#include <QComboBox>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QSpinBox>
#include <QTimer>
#include <QToolButton>
#include <QWidget>

#include "core/base/clock.h"
#include "widgets/link_panel.h"
#include "widgets/state_dot.h"

namespace usar::widgets {

class ElidedLabel;

/// The simulator inside this program, or a USARSim server in the network.
enum class ServerChoice { Embedded, Real };

/// Waiting: the last try failed, and the next one comes by itself.
enum class ConnectionState { Disconnected, Connecting, Connected, Waiting };

/// How much of the bar there is room for. Medium: a choice that cannot be made now is not shown. Narrow: neither is the
/// word on the button while there is a link.
enum class BarRoom { Wide, Medium, Narrow };

/// What the bar says. `where` is shown when connected ("tall_test"); `reason` is a sentence with the mend.
struct ConnectionStatus {
    ConnectionState state = ConnectionState::Disconnected;
    QString where;
    QString reason;        ///< without the time to the next try, which the bar adds
    Seconds retry_in{0.0}; ///< while Waiting
    bool operator==(const ConnectionStatus&) const = default;
};

/// Choice, host and port in; connect and disconnect out. It never connects by itself. While waiting the seconds to the
/// next try run down by wall time. GUI thread.
class ConnectionBar : public QWidget {
    Q_OBJECT
public:
    explicit ConnectionBar(QWidget* parent = nullptr);

    /// Emits serverChanged when it differs.
    void setServer(ServerChoice choice);
    /// As chosen now, connected or not.
    ServerChoice server() const;
    /// Kept for the real server; the embedded one needs none.
    void setAddress(const QString& host, quint16 port);
    /// As typed, without blanks around it; may be empty.
    QString host() const;
    quint16 port() const;
    /// Locks the choice while there is a link or a try; the same status again costs nothing.
    void setStatus(const ConnectionStatus& status);
    void setRoom(BarRoom room);
    /// Info lines per second of wall time; nothing hides the figure.
    void setRate(std::optional<double> lines_per_s);
    /// Opens from the rate; always there, for whoever feeds it.
    LinkPanel* panel() const { return panel_; }
    void openPanel() { panel_->openBelow(rate_); }
    /// All that is said now, also where there is no room to show it.
    QString statusText() const;

signals:
    /// For a real server: the host is trimmed and not empty. For the embedded one host and port say nothing.
    void connectRequested(usar::widgets::ServerChoice choice, const QString& host, quint16 port);
    /// Also "give up trying" while connecting or waiting.
    void disconnectRequested();
    /// By the person or by setServer.
    void serverChanged(usar::widgets::ServerChoice choice);

protected:
    void changeEvent(QEvent* event) override;

private:
    void setUpAddress();
    void setUpStatus();
    void countDown();
    void showWords();
    /// What the button means depends on the state.
    void press();
    void refresh();

    ConnectionStatus status_; ///< as it was told
    BarRoom room_ = BarRoom::Wide;
    int button_width_px_ = 0; ///< of its longest word
    Seconds retry_in_{0.0};   ///< runs down from there
    QTimer second_{this};
    QComboBox* server_;
    QLineEdit* host_;
    QSpinBox* port_;
    QPushButton* button_;
    StateDot* dot_;
    ElidedLabel* status_text_; ///< ends in "…" where there is no room
    QLabel* retry_;            ///< never does: it is what changes
    QToolButton* rate_;
    LinkPanel* panel_;
};

} // namespace usar::widgets
