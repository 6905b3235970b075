// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#include "bifs/config.h"

#include "codec/bit_reader.h"
#include "codec/bit_writer.h"

namespace afx::bifs {

namespace {

using codec::BitReader;

constexpr uint8_t kMaxIdBits = 31;

uint8_t read_width(BitReader& in, std::string_view name) {
  return static_cast<uint8_t>(in.u(5, name));
}

Result<BifsConfig> read_form(std::span<const uint8_t> data, uint8_t version,
                             Diagnostics& diagnostics) {
  BitReader in(data);
  const BitReader::Scope scope(in, version == 1 ? "BIFSConfig" : "BIFSv2Config");
  BifsConfig config;
  config.version = version;
  if (version == 2) {
    config.use_3d_mesh_coding = in.u(1, "use3DMeshCoding") != 0;
    config.use_predictive_field = in.u(1, "usePredictiveMFField") != 0;
  }
  config.node_id_bits = read_width(in, "nodeIDbits");
  config.route_id_bits = read_width(in, "routeIDbits");
  if (version == 2) config.proto_id_bits = read_width(in, "protoIDbits");
  const bool is_command_stream = in.u(1, "isCommandStream") != 0;
  if (!is_command_stream)
    in.fail(Errc::unsupported,
            std::string(version == 1 ? "BIFSConfig" : "BIFSv2Config") +
                "/isCommandStream is 0: BIFS-Anim is not read [expected a command stream]");
  config.pixel_metric = in.u(1, "pixelMetric") != 0;
  if (in.u(1, "hasSize") != 0) {
    DisplaySize size;
    size.width = static_cast<uint16_t>(in.u(16, "pixelWidth"));
    size.height = static_cast<uint16_t>(in.u(16, "pixelHeight"));
    config.size = size;
  }
  in.align(diagnostics);
  if (in.ok() && in.bits_left() > 0)
    in.fail(Errc::malformed, "bytes are left over after the configuration [expected none]");
  if (!in.ok()) return in.error();
  return config;
}

}  // namespace

Result<BifsConfig> read_config(std::span<const uint8_t> data, uint8_t oti,
                               Diagnostics& diagnostics) {
  if (oti == kOtiBifsExtended)
    return Error{Errc::unsupported, Place::at_bit(0),
                 "BIFSConfigEx (object type indication 4) is not read [expected 1 or 2]"};
  if (oti != kOtiBifs && oti != kOtiBifsV2)
    return Error{Errc::unsupported, Place::at_bit(0),
                 "object type indication " + std::to_string(oti) +
                     " is not that of a BIFS stream [expected 1 or 2]"};
  Result<BifsConfig> named = read_form(data, oti, diagnostics);
  if (named.ok()) return named;
  Diagnostics other_diagnostics;
  Result<BifsConfig> other = read_form(data, oti == kOtiBifs ? 2 : 1, other_diagnostics);
  if (!other.ok()) return named;
  diagnostics.append(other_diagnostics);
  diagnostics.warn("config_form", Place::at_bit(0),
                   "the configuration has the other form than object type indication " +
                       std::to_string(oti) + " says");
  return other;
}

Result<std::vector<uint8_t>> write_config(const BifsConfig& config) {
  const bool widths_fit = config.node_id_bits <= kMaxIdBits && config.route_id_bits <= kMaxIdBits &&
                          config.proto_id_bits <= kMaxIdBits;
  const bool plain =
      config.proto_id_bits == 0 && !config.use_3d_mesh_coding && !config.use_predictive_field;
  if (!widths_fit) return Error{Errc::bad_argument, {}, "an ID width above 31 bits"};
  if (config.version != 2 && !(config.version == 1 && plain))
    return Error{Errc::bad_argument, {}, "the configuration needs version 2 [expected version 2]"};
  std::vector<uint8_t> bytes;
  codec::BitWriter out(bytes);
  if (config.version == 2) {
    out.u(config.use_3d_mesh_coding ? 1 : 0, 1);
    out.u(config.use_predictive_field ? 1 : 0, 1);
  }
  out.u(config.node_id_bits, 5);
  out.u(config.route_id_bits, 5);
  if (config.version == 2) out.u(config.proto_id_bits, 5);
  out.u(1, 1);  // isCommandStream
  out.u(config.pixel_metric ? 1 : 0, 1);
  out.u(config.size ? 1 : 0, 1);
  if (config.size) {
    out.u(config.size->width, 16);
    out.u(config.size->height, 16);
  }
  return bytes;
}

}  // namespace afx::bifs
