// A server's port gets datagrams of anybody.
#include "samples/netplay/enet_transport.h"

#include <gtest/gtest.h>
#include <netinet/in.h>
#include <sys/socket.h>
#include <unistd.h>

namespace netplay {
namespace {

constexpr int kRounds = 10;  // of both ends, in which a connect comes through

/// A socket without ENet, on a port of the loopback.
class Socket {
public:
    Socket() : m_file(::socket(AF_INET, SOCK_DGRAM, 0)) {
        const sockaddr_in any = addressOf(0);
        EXPECT_EQ(::bind(m_file, reinterpret_cast<const sockaddr*>(&any), sizeof any), 0);
    }
    ~Socket() { ::close(m_file); }
    Socket(const Socket&) = delete;
    Socket& operator=(const Socket&) = delete;

    uint16_t port() const {
        sockaddr_in address{};
        socklen_t size = sizeof address;
        EXPECT_EQ(::getsockname(m_file, reinterpret_cast<sockaddr*>(&address), &size), 0);
        return ntohs(address.sin_port);
    }
    void send(uint16_t port, const std::vector<uint8_t>& bytes) {
        const sockaddr_in to = addressOf(port);
        EXPECT_EQ(::sendto(m_file, bytes.data(), bytes.size(), 0, reinterpret_cast<const sockaddr*>(&to), sizeof to),
                  ssize_t(bytes.size()));
    }
    std::vector<uint8_t> receive() {
        std::vector<uint8_t> bytes(2000);
        bytes.resize(size_t(::recv(m_file, bytes.data(), bytes.size(), 0)));
        return bytes;
    }

private:
    static sockaddr_in addressOf(uint16_t port) {
        sockaddr_in address{};
        address.sin_family = AF_INET;
        address.sin_port = htons(port);
        address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
        return address;
    }
    int m_file;
};

/// The first datagram of a client.
std::vector<uint8_t> connectDatagram() {
    Socket socket;
    const auto client = connectWithEnet("127.0.0.1", socket.port());
    client->tick();
    return socket.receive();
}

void tick(Transport& transport) {
    Event event;
    while (transport.receive(event)) {
    }
    transport.tick();
}

/// Whether a new client gets through in a few rounds.
bool canConnect(Transport& server) {
    const auto client = connectWithEnet("127.0.0.1", portOf(server));
    for (int round = 0; round < kRounds; ++round) {
        client->tick();
        tick(server);
        Event event;
        if (client->receive(event)) return event.kind == Event::Kind::Connected;
    }
    return false;
}

/// Sends the first datagram of 400 clients, which never confirm.
void connectWithoutConfirming(Transport& server) {
    const std::vector<uint8_t> connect = connectDatagram();
    std::vector<std::unique_ptr<Socket>> sockets;  // ports of their own
    for (int i = 0; i < 400; ++i) {
        sockets.push_back(std::make_unique<Socket>());
        sockets.back()->send(portOf(server), connect);
        if (i % 50 == 0) tick(server);
    }
}

TEST(EnetTransport, EmptyAndLongDatagramsDoNotHoldUpOthers) {
    for (const size_t bytes : {0, 5000}) {
        const auto server = listenWithEnet(0, 4);
        Socket sender;
        for (int i = 0; i < (bytes ? 20 : 200); ++i) sender.send(portOf(*server), std::vector<uint8_t>(bytes));
        EXPECT_TRUE(canConnect(*server)) << bytes << " bytes";
    }
}

TEST(EnetTransport, ConnectsThatNobodyConfirmsDoNotKeepOthersOut) {
    const auto server = listenWithEnet(0, 4);
    connectWithoutConfirming(*server);
    EXPECT_TRUE(canConnect(*server));
}

TEST(EnetTransport, APlayerKeepsHisPlaceWhenOthersConnect) {
    const auto server = listenWithEnet(0, 4);
    const auto client = connectWithEnet("127.0.0.1", portOf(*server));
    Event event;
    for (int round = 0; round < kRounds && !client->receive(event); ++round) client->tick(), tick(*server);
    ASSERT_EQ(event.kind, Event::Kind::Connected);
    client->tick(), tick(*server);  // the server hears of it
    connectWithoutConfirming(*server);
    client->send(event.peer, Delivery::Reliable, std::vector<uint8_t>{1, 2, 3});
    client->tick();
    std::vector<uint8_t> got;
    while (server->receive(event))
        if (event.kind == Event::Kind::Received) got = event.bytes;
    EXPECT_EQ(got, (std::vector<uint8_t>{1, 2, 3}));
}

}  // namespace
}  // namespace netplay
