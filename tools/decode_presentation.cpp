// SPDX-License-Identifier: BSD-2-Clause
// SPDX-FileCopyrightText: 2026 the afx authors
#include <filesystem>
#include <nlohmann/json.hpp>
#include <utility>

#include "afx/decoded_scene.h"
#include "afx/file.h"
#include "afx/scene_packing.h"
#include "bifs/bt_writer.h"
#include "bifs/xmt_writer.h"
#include "nodes/scene_writer.h"
#include "tools/decode.h"
#include "tools/scene_input.h"

namespace afx::tools {
namespace {

namespace fs = std::filesystem;

/// An output that is begun when its first piece comes: not before the input has been looked at.
class Text {
 public:
  Text(OutputFiles& outputs, std::string path, bool dry_run)
      : outputs_(outputs), path_(std::move(path)), dry_run_(dry_run) {}

  Status operator()(std::string_view piece) {
    bytes += piece.size();
    if (dry_run_) return {};
    if (!sink_) {
      auto begun = outputs_.begin(path_);
      if (!begun.ok()) return begun.error();
      sink_ = std::move(begun).value();
    }
    return sink_({reinterpret_cast<const uint8_t*>(piece.data()), piece.size()});
  }

  uint64_t bytes = 0;

 private:
  OutputFiles& outputs_;
  std::string path_;
  bool dry_run_;
  OutputFiles::Sink sink_;
};

/// The input's name as the output names it: relative to the output's folder.
std::string name_of_input(const Input& input, const std::string& output) {
  if (input.path == "-" || output == "-") return input.path;
  std::error_code failure;
  const fs::path folder = fs::absolute(output, failure).parent_path();
  const fs::path relative = fs::proximate(fs::absolute(input.path, failure), folder, failure);
  return failure || relative.empty() ? input.path : relative.generic_string();
}

/// A scene as it is at the end, with its pictures beside it.
Status write_scene(const DecodeOptions& options, const CodedScene& coded,
                   const bifs::PresentationDecodeOptions& how, const Session& session,
                   OutputFiles& outputs, Text& text, std::vector<std::string>& lines,
                   Diagnostics& diagnostics) {
  auto decoded = decode_scene(coded.source, coded.movie, how, diagnostics);
  if (!decoded.ok()) return decoded.error();
  if (decoded.value().commands > 1)
    diagnostics.warn(
        "commands_carried_out", Place::none(),
        "a plain scene has no commands: " + counted(decoded.value().commands, "command") + " in " +
            counted(decoded.value().frames, "access unit") +
            " are carried out, and the scene is as it is then (expected .bt or .xmt to "
            "keep them)");
  const fs::path output(options.output);
  UnpackOptions unpack;
  unpack.limits = session.limits;
  if (options.output != "-") {
    unpack.stem = output.stem().string();
    unpack.taken = {output.filename().string()};
  }
  auto pictures = unpack_scene(decoded.value().scene, decoded.value().streams, unpack, diagnostics);
  if (!pictures.ok()) return pictures.error();
  for (const NamedFile& picture : pictures.value()) {
    if (options.output == "-") {
      diagnostics.warn("lost_picture", Place::none(),
                       "the picture " + picture.name + " is left out: there is no folder for it");
      continue;
    }
    const std::string path = (output.parent_path() / picture.name).string();
    std::error_code failure;  // a folder that is not there is what check() tells
    if (!session.options.dry_run) fs::create_directories(fs::path(path).parent_path(), failure);
    if (Status free = outputs.check(path); !free.ok()) return free;
    lines.push_back(path + ": " + counted(picture.bytes.size(), "byte"));
    if (session.options.dry_run) continue;
    if (Status put = outputs.put(path, picture.bytes); !put.ok()) return put;
  }
  return nodes::write_scene_text_to(std::ref(text), decoded.value().scene, {.vrml_header = true});
}

Status write_presentation(const std::string& format, const CodedScene& coded,
                          const bifs::PresentationDecodeOptions& how, Text& text,
                          Diagnostics& diagnostics) {
  if (format == "json")
    return bifs::decode_as_json(coded.source, coded.movie, how, std::ref(text), diagnostics);
  std::unique_ptr<bifs::PresentationSink> writer;
  if (format == "xmt") {
    writer = std::make_unique<bifs::XmtWriter>(std::ref(text));
  } else {
    writer = std::make_unique<bifs::BtWriter>(std::ref(text));
  }
  const auto scene =
      bifs::decode_presentation(coded.source, coded.movie, how, writer.get(), diagnostics);
  return scene.ok() ? Status() : Status(scene.error());
}

}  // namespace

int decode_presentation(const DecodeOptions& options, const std::string& format, const Input& input,
                        OutputFiles& outputs, const Session& session, Diagnostics& diagnostics) {
  auto coded = open_coded_scene(input, session.limits, diagnostics);
  if (!coded.ok()) return session.fail(coded.error(), input.path, diagnostics);
  bifs::PresentationDecodeOptions how;
  how.file_name = name_of_input(input, options.output);
  how.limits = session.limits;
  how.drop_coding_quantizers = format != "json";
  Text text(outputs, options.output, session.options.dry_run);
  std::vector<std::string> lines;
  const Status done =
      format == "wrl"
          ? write_scene(options, coded.value(), how, session, outputs, text, lines, diagnostics)
          : write_presentation(format, coded.value(), how, text, diagnostics);
  if (!done.ok()) return session.fail(done.error(), input.path, diagnostics);
  if (const int code = session.warn(diagnostics, input.path); code != kDone) return code;
  lines.insert(lines.begin(), options.output + ": " + counted(text.bytes, "byte"));
  return session.finish(outputs, options.output, lines,
                        {{"output", options.output}, {"bytes", text.bytes}});
}

}  // namespace afx::tools
